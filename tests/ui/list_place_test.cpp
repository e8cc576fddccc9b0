// How far a list was scrolled outlives a filling anew, a session, and a dock that nobody raised.
#include <gtest/gtest.h>

#include <QListWidget>
#include <QScrollBar>
#include <QSettings>
#include <QTest>
#include <QVBoxLayout>

#include "ui/browse/list_place.h"

namespace dermis {
namespace {

const QString kKey = QStringLiteral("test/scroll");

class ListPlaces : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().setValue(kKey, 300);
    holder.resize(200, 200);
    list = new QListWidget(&holder);
    list->setGeometry(0, 0, 200, 200);
    place = std::make_unique<ListPlace>(*list, kKey);
    fill();
  }
  void TearDown() override { QSettings().remove(kKey); }
  void fill() {
    place->hold();
    list->clear();
    for (int i = 0; i < 100; ++i) list->addItem(QString::number(i));
    place->settle();
  }
  void show() {
    list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    holder.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&holder));
  }
  [[nodiscard]] int scrolled() const { return list->verticalScrollBar()->value(); }
  QWidget holder;
  QListWidget* list = nullptr;
  std::unique_ptr<ListPlace> place;
};

TEST_F(ListPlaces, AreFoundAgainOnceTheListIsSeen) {
  show();
  EXPECT_TRUE(QTest::qWaitFor([this] { return scrolled() == 300; }, 3000)) << scrolled();
}

TEST_F(ListPlaces, AreKeptOfAListThatNobodySaw) {
  place.reset();
  EXPECT_EQ(QSettings().value(kKey).toInt(), 300);
}

TEST_F(ListPlaces, AreKeptWhileTheListIsFilledAnew) {
  show();
  ASSERT_TRUE(QTest::qWaitFor([this] { return scrolled() == 300; }, 3000));
  list->verticalScrollBar()->setValue(150);
  fill();
  EXPECT_TRUE(QTest::qWaitFor([this] { return scrolled() == 150; }, 3000)) << scrolled();
  place.reset();
  EXPECT_EQ(QSettings().value(kKey).toInt(), 150);
}

}  // namespace
}  // namespace dermis
