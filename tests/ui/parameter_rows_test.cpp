// Real sliders, fields and switches on the real window: what a hand does, and what document and picture make of it.
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QWheelEvent>

#include "core/material/parameter_table.h"
#include "ui/editor_fixture.h"
#include "ui/rows/choice_editors.h"
#include "ui/rows/number_text.h"

namespace dermis {
namespace {

using ParameterRows = Editor;

TEST_F(ParameterRows, DraggingASliderChangesThePictureAndIsOneEntry) {
  const QImage before = picture();
  const float start = document().currentLook()->worn.material.parameters.specularPerceptualRoughness;
  auto* slider = find<ValueSlider>(QStringLiteral("specular.perceptual_roughness.slider"));
  ASSERT_NE(slider, nullptr);
  reveal(slider);
  drag(slider, slider->handleCentre(), -60);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_LT(document().currentLook()->worn.material.parameters.specularPerceptualRoughness, start);
  const QImage after = picture();
  EXPECT_GT(meanDifference(before, after), 0.05F);
  EXPECT_TRUE(document().isModified());

  undo().undo();
  EXPECT_FALSE(document().isModified());
  EXPECT_LT(meanDifference(before, picture()), 0.05F);
}

TEST_F(ParameterRows, ComingBackToTheStartLeavesNoEntry) {
  auto* slider = find<ValueSlider>(QStringLiteral("specular.lobe_mix.slider"));
  reveal(slider);
  const Scene start = document().scene();
  const QPoint from = slider->handleCentre();
  QTest::mousePress(slider, Qt::LeftButton, {}, from);
  for (const int away : {-10, -30, -10, 0}) {
    const QPointF at = QPointF(from) + QPointF(away, 0);
    QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(slider, &move);
  }
  QTest::mouseRelease(slider, Qt::LeftButton, {}, from);
  EXPECT_EQ(undo().count(), 0);
  EXPECT_EQ(document().scene(), start);
}

TEST_F(ParameterRows, ShiftIsFineAndCtrlSnaps) {
  auto* slider = find<ValueSlider>(QStringLiteral("subsurface.weight.slider"));
  reveal(slider);
  const auto weight = [this] { return document().currentLook()->worn.material.parameters.subsurfaceWeight; };
  drag(slider, slider->handleCentre(), -40, Qt::ShiftModifier);
  const float fine = 1.0F - weight();
  undo().undo();
  drag(slider, slider->handleCentre(), -40);
  const float coarse = 1.0F - weight();
  EXPECT_NEAR(coarse / fine, 10.0F, 1.5F);
  drag(slider, slider->handleCentre(), -13, Qt::ControlModifier);
  const float twentieths = weight() * 20.0F;
  EXPECT_NEAR(twentieths, std::round(twentieths), 1e-3F);
}

TEST_F(ParameterRows, TypingTakesCommaOrPointAndPassesTheSoftRange) {
  auto* field = find<NumberField>(QStringLiteral("subsurface.scale.number"));
  reveal(field);
  const auto scale = [this] { return document().currentLook()->worn.material.parameters.subsurfaceScale; };
  const auto type = [&](const QString& words) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, words);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type(QStringLiteral("0,45"));
  EXPECT_FLOAT_EQ(scale(), 0.45F);
  type(QStringLiteral("12.5"));
  EXPECT_FLOAT_EQ(scale(), 12.5F);  // soft range 0..4
  type(QStringLiteral("1000"));
  EXPECT_FLOAT_EQ(scale(), 100.0F);  // hard range
  type(QStringLiteral("nonsense"));
  EXPECT_FLOAT_EQ(scale(), 100.0F);
}

TEST_F(ParameterRows, TheWheelWorksOnlyWithTheFocusAndTicksMerge) {
  auto* slider = find<ValueSlider>(QStringLiteral("subsurface.albedo_mix.slider"));
  reveal(slider);
  const auto tick = [&] {
    const QPointF at = slider->rect().center();
    QWheelEvent wheel(at, slider->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(slider, &wheel);
  };
  slider->clearFocus();
  tick();
  EXPECT_EQ(undo().count(), 0);
  window->activateWindow();
  slider->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return slider->hasFocus(); }, 3000));
  for (int i = 0; i < 3; ++i) tick();
  EXPECT_EQ(undo().count(), 1);
  EXPECT_NEAR(document().currentLook()->worn.material.parameters.subsurfaceAlbedoMix, 0.53F, 1e-4F);
}

TEST_F(ParameterRows, DoubleClickOnTheLabelResets) {
  const QString slot = document().currentSlot();
  document().setParameter(slot, "specular.lobe_mix", 0.1F, newGesture());
  auto* row = find<PropertyRow>(QStringLiteral("specular.lobe_mix"));
  reveal(row);
  EXPECT_TRUE(row->isModified());
  QTest::mouseDClick(row->childAt(40, 10), Qt::LeftButton);
  EXPECT_FALSE(row->isModified());
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.specularLobeMix, 0.85F);
  EXPECT_EQ(undo().count(), 2);
}

TEST_F(ParameterRows, EveryRowOfEveryModelIsReachableAndNamed) {
  const QString slot = document().currentSlot();
  for (const ShadingModelRow& model : shadingModels()) {
    document().setShadingModel({slot}, model.model);
    for (const ParameterRow& parameter : parameterTable()) {
      const QString id = QString::fromUtf8(parameter.id.data(), static_cast<qsizetype>(parameter.id.size()));
      auto* row = find<PropertyRow>(id);
      ASSERT_NE(row, nullptr) << parameter.id;
      EXPECT_EQ(!row->isHidden(), parameter.usedBy(model.model)) << parameter.id << " in " << model.id;
      EXPECT_TRUE(row->accessibleName().contains(QStringLiteral(" › "))) << parameter.id;
    }
  }
}

TEST_F(ParameterRows, SwitchingTheModelAndBackKeepsTheValues) {
  const QString slot = document().currentSlot();
  document().setParameter(slot, "subsurface.scale", 2.5F, newGesture());
  auto* model = find<QComboBox>(QStringLiteral("material.model"));
  reveal(model);
  const int skin = model->currentIndex();
  for (const int index : {static_cast<int>(ShadingModel::Thesis), skin}) {
    model->setCurrentIndex(index);
    Q_EMIT model->activated(index);
  }
  EXPECT_FLOAT_EQ(document().currentLook()->worn.material.parameters.subsurfaceScale, 2.5F);
  EXPECT_EQ(document().currentLook()->worn.material.model, ShadingModel::Skin);
}

TEST_F(ParameterRows, TheSlotComboShowsTheOtherSlotsValues) {
  auto* slots_ = find<QComboBox>(QStringLiteral("material.slot"));
  ASSERT_EQ(slots_->count(), 4);
  const QString first = document().currentSlot();
  document().setParameter(first, "specular.perceptual_roughness", 0.9F, newGesture());
  document().setCurrentSlot(slots_->itemText(2));
  auto* field = find<NumberField>(QStringLiteral("specular.perceptual_roughness.number"));
  EXPECT_NE(field->value(), 0.9);
  document().setCurrentSlot(first);
  EXPECT_NEAR(field->value(), 0.9, 1e-6);
}

TEST_F(ParameterRows, ASliderCompilesNothingBakesNothingAndUploadsNoTexture) {
  picture();
  const RenderStatistics before = window->viewport()->statistics();
  auto* slider = find<ValueSlider>(QStringLiteral("specular.intensity.slider"));
  reveal(slider);
  drag(slider, slider->handleCentre(), -20);
  picture();
  const RenderStatistics after = window->viewport()->statistics();
  EXPECT_GT(after.frames, before.frames);
  EXPECT_EQ(after.environmentsBaked, before.environmentsBaked);
  EXPECT_EQ(after.texturesUploaded, before.texturesUploaded);
  EXPECT_EQ(after.geometryUploads, before.geometryUploads);
}

TEST_F(ParameterRows, SearchFindsByGroupLabelAndId) {
  auto* search = find<QLineEdit>(QStringLiteral("material.search"));
  reveal(search);
  search->setText(QStringLiteral("subsurface sca"));
  EXPECT_FALSE(find<PropertyRow>(QStringLiteral("subsurface.scale"))->isHidden());
  EXPECT_TRUE(find<PropertyRow>(QStringLiteral("specular.ior"))->isHidden());
  search->clear();
  EXPECT_FALSE(find<PropertyRow>(QStringLiteral("specular.ior"))->isHidden());
}

TEST_F(ParameterRows, CtrlFFindsTheSearchAndEscapeEmptiesIt) {
  auto* search = find<QLineEdit>(QStringLiteral("material.search"));
  reveal(find<PropertyRow>(QStringLiteral("environment.exposure_stops")));
  window->activateWindow();
  window->viewport()->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->viewport()->hasFocus(); }, 3000));
  QTest::keyClick(window->viewport(), Qt::Key_F, Qt::ControlModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return search->hasFocus(); }, 3000));
  QTest::keyClicks(search, QStringLiteral("ior"));
  EXPECT_TRUE(find<PropertyRow>(QStringLiteral("subsurface.scale"))->isHidden());
  QTest::keyClick(search, Qt::Key_Escape);
  EXPECT_TRUE(search->text().isEmpty());
  EXPECT_FALSE(find<PropertyRow>(QStringLiteral("subsurface.scale"))->isHidden());
}

TEST_F(ParameterRows, EveryRowSaysWhatItMeansInItsTip) {
  for (const ParameterRow& parameter : parameterTable()) {
    auto* row = find<PropertyRow>(QString::fromUtf8(parameter.id.data(), static_cast<qsizetype>(parameter.id.size())));
    ASSERT_NE(row, nullptr);
    const auto words = [](std::string_view utf8) {
      return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size())).toHtmlEscaped();
    };
    for (QWidget* control : row->editor()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      EXPECT_TRUE(control->whatsThis().contains(words(parameter.sentence)))
          << parameter.id << " " << control->metaObject()->className();
    EXPECT_TRUE(row->toolTip().contains(words(parameter.sentence))) << parameter.id;
    EXPECT_TRUE(row->toolTip().contains(words(parameter.source))) << parameter.id;
  }
}

TEST_F(ParameterRows, StepsWithinAPauseAreOneEntryAndBackAgainIsNone) {
  auto* field = find<NumberField>(QStringLiteral("specular.lobe_mix.number"));
  reveal(field);
  window->activateWindow();
  field->setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return field->hasFocus(); }, 3000));
  for (int i = 0; i < 4; ++i) QTest::keyClick(field, Qt::Key_Down);
  EXPECT_EQ(undo().count(), 1);
  for (int i = 0; i < 4; ++i) QTest::keyClick(field, Qt::Key_Up);
  EXPECT_EQ(undo().count(), 0);
  QTest::keyClick(field, Qt::Key_Down);
  QTest::qWait(450);
  QTest::keyClick(field, Qt::Key_Down);
  EXPECT_EQ(undo().count(), 2);
}

TEST_F(ParameterRows, TypingTakesUnits) {
  auto* field = find<NumberField>(QStringLiteral("transmission.thickness_max_mm.number"));
  reveal(field);
  const auto thickness = [this] {
    return document().currentLook()->worn.material.parameters.transmissionThicknessMaxMm;
  };
  const auto type = [&](const QString& words) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, words);
    QTest::keyClick(field, Qt::Key_Return);
  };
  type(QStringLiteral("0.5 cm"));
  EXPECT_FLOAT_EQ(thickness(), 5.0F);
  type(QStringLiteral("0,012 m"));
  EXPECT_FLOAT_EQ(thickness(), 12.0F);
  type(QStringLiteral("1in"));
  EXPECT_FLOAT_EQ(thickness(), 25.4F);
  type(QStringLiteral("3 kg"));
  EXPECT_FLOAT_EQ(thickness(), 25.4F);
}

TEST(NumberText, ReadsCommasGroupsAndUnits) {
  const auto read = [](const char* words, const char* unit = "") {
    return parseNumber(QString::fromUtf8(words), QString::fromUtf8(unit));
  };
  EXPECT_DOUBLE_EQ(*read("0,45"), 0.45);
  EXPECT_DOUBLE_EQ(*read("1.234,5"), 1234.5);
  EXPECT_DOUBLE_EQ(*read("1,234.5"), 1234.5);
  EXPECT_DOUBLE_EQ(*read("-3e-2"), -0.03);
  EXPECT_DOUBLE_EQ(*read("−2"), -2.0);
  EXPECT_DOUBLE_EQ(*read("45 %"), 0.45);
  EXPECT_DOUBLE_EQ(*read("0.5 cm", "mm"), 5.0);
  EXPECT_DOUBLE_EQ(*read("250 µm", "mm"), 0.25);
  EXPECT_DOUBLE_EQ(*read("2 mm", "mm"), 2.0);
  EXPECT_NEAR(*read("1.5708 rad", "°"), 90.0, 1e-3);
  EXPECT_DOUBLE_EQ(*read("0.01 cm²", "mm²"), 1.0);
  EXPECT_DOUBLE_EQ(*read("1 mm2", "mm²"), 1.0);
  EXPECT_DOUBLE_EQ(*read("2 x", "×"), 2.0);
  EXPECT_FALSE(read("2 mm"));
  EXPECT_FALSE(read("2 kg", "mm"));
  EXPECT_FALSE(read("2 mm", "mm²"));
  EXPECT_FALSE(read("mm", "mm"));
  EXPECT_FALSE(read(""));
}

TEST(NumberFields, AreRightInALocaleWithADecimalComma) {
  const QLocale before;
  QLocale::setDefault(QLocale(QLocale::Croatian, QLocale::Croatia));
  ASSERT_EQ(QLocale().decimalPoint(), QStringLiteral(","));
  {
    QWidget holder;
    NumberField field(NumberRange{0.0, 10000.0, 0.0, 1.0, QStringLiteral("mm")}, &holder);
    holder.show();
    holder.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&holder, kPatienceMs));
    const auto typed = [&](const char* words) {
      field.setFocus();
      field.selectAll();
      QTest::keyClicks(&field, QLatin1String(words));
      QTest::keyClick(&field, Qt::Key_Return);
      return field.value();
    };
    EXPECT_DOUBLE_EQ(typed("0,45"), 0.45);
    EXPECT_DOUBLE_EQ(typed("0.75"), 0.75);
    EXPECT_DOUBLE_EQ(typed("1.250,5"), 1250.5);
    EXPECT_DOUBLE_EQ(typed("1,5 cm"), 15.0);
    // What it shows can be typed again and means the same.
    field.showNumber(1234.5);
    EXPECT_DOUBLE_EQ(*parseNumber(field.text()), 1234.5);
    QTest::keyClick(&field, Qt::Key_Up);
    EXPECT_GT(field.value(), 1234.5);
    EXPECT_LT(field.value(), 1235.0);
  }
  QLocale::setDefault(before);
}

TEST(NumberFields, ShowTheDigitsThatFitAndKeepTheOthers) {
  QWidget holder;
  NumberField field(NumberRange{0.0, 10.0, 0.0, 1.0, {}}, &holder);
  field.setGeometry(0, 0, 46, 24);
  holder.resize(200, 40);
  holder.show();
  holder.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&holder, kPatienceMs));
  QSignalSpy edited(&field, &NumberField::edited);
  holder.setFocus();
  field.showNumber(0.482993);
  EXPECT_LE(field.fontMetrics().horizontalAdvance(field.text()), 46);
  EXPECT_NEAR(field.text().toDouble(), 0.482993, 0.06);
  EXPECT_DOUBLE_EQ(field.value(), 0.482993);
  EXPECT_EQ(field.toolTip(), QStringLiteral("0.482993"));
  field.setFocus();
  EXPECT_EQ(field.text(), QStringLiteral("0.482993"));
  field.clearFocus();
  EXPECT_DOUBLE_EQ(field.value(), 0.482993);
  EXPECT_TRUE(edited.isEmpty());
  field.showNumber(0.00004);
  EXPECT_GT(field.text().toDouble(), 0.0);
}

}  // namespace
}  // namespace dermis
