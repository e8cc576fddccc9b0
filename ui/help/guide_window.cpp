#include "ui/help/guide_window.h"

#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QFrame>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"
#include "ui/theme/strips.h"

// A static library's resources have to be asked for, and from outside any namespace.
static void loadGuide() { Q_INIT_RESOURCE(guide); }

namespace dermis {
namespace {

constexpr int kPageRole = Qt::UserRole;
constexpr int kHeadingRole = Qt::UserRole + 1;
const QString kRoot = QStringLiteral(":/guide/");
const QString kKeys = QStringLiteral("keys");

struct Heading {
  int level = 0;
  QString text;
};

std::vector<Heading> headingsOf(const QString& markdown) {
  static const QRegularExpression kHeading(QStringLiteral("^(#{1,3}) +(.+)$"), QRegularExpression::MultilineOption);
  std::vector<Heading> headings;
  for (auto it = kHeading.globalMatch(markdown); it.hasNext();) {
    const QRegularExpressionMatch match = it.next();
    headings.push_back({static_cast<int>(match.captured(1).size()), match.captured(2).remove(QLatin1Char('`'))});
  }
  return headings;
}

}  // namespace

GuideWindow::GuideWindow(const Shortcuts& shortcuts, QWidget* parent)
    : QWidget(parent, Qt::Window), m_shortcuts(shortcuts) {
  loadGuide();
  setObjectName(QStringLiteral("guide"));
  setWindowTitle(tr("Guide — Dermis"));
  resize(1060, 780);
  QVBoxLayout* column = flushColumn(this);
  QFrame* strip = toolStrip(this);
  auto* head = new QHBoxLayout(strip);
  head->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin, metrics::kMargin);
  m_search = new QLineEdit(strip);
  m_search->setObjectName(QStringLiteral("guide.search"));
  m_search->setAccessibleName(tr("Search the guide"));
  m_search->setToolTip(tr("Pages without these words are hidden; Enter goes to the next place on the page"));
  m_search->setPlaceholderText(tr("Search the guide"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themeIcon("search"), QLineEdit::LeadingPosition);
  m_search->setMaximumWidth(320);
  m_found = new QLabel(strip);
  m_found->setObjectName(QStringLiteral("guide.found"));
  m_found->setProperty("quiet", true);
  head->addWidget(m_search, 1);
  head->addWidget(m_found, 1);
  column->addWidget(strip);
  auto* split = new QSplitter(Qt::Horizontal, this);
  m_contents = new QTreeWidget(split);
  m_contents->setObjectName(QStringLiteral("guide.contents"));
  m_contents->setAccessibleName(tr("Contents"));
  m_contents->setToolTip(tr("Pages of the guide and their sections"));
  m_contents->setHeaderHidden(true);
  m_text = new QTextBrowser(split);
  m_text->setObjectName(QStringLiteral("guide.text"));
  m_text->setAccessibleName(tr("Guide"));
  m_text->setOpenLinks(false);
  m_text->setSearchPaths({kRoot});
  m_text->document()->setDocumentMargin(22);
  split->addWidget(m_contents);
  split->addWidget(m_text);
  split->setStretchFactor(1, 1);
  split->setSizes({280, 780});
  column->addWidget(split, 1);
  fillContents();
  connect(m_contents, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item != nullptr) open(item->data(0, kPageRole).toString(), item->data(0, kHeadingRole).toString());
  });
  // Not this window's size: the text has its own only when the layout, or the splitter, has given it one.
  m_text->viewport()->installEventFilter(this);
  connect(m_search, &QLineEdit::textChanged, this, &GuideWindow::search);
  connect(m_search, &QLineEdit::returnPressed, this, &GuideWindow::findNext);
  connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    if (url.scheme().startsWith(QStringLiteral("http")))
      QDesktopServices::openUrl(url);
    else
      open(url.fileName());
  });
  open(QStringLiteral("user-guide.md"));
}

void GuideWindow::fillContents() {
  const auto add = [this](const QString& page) {
    QList<QTreeWidgetItem*> parents;
    for (const Heading& heading : headingsOf(pageText(page))) {
      const auto depth = static_cast<qsizetype>(heading.level) - 1;
      while (parents.size() > depth) parents.removeLast();
      auto* item = parents.isEmpty() ? new QTreeWidgetItem(m_contents) : new QTreeWidgetItem(parents.last());
      item->setText(0, heading.text);
      item->setData(0, kPageRole, page);
      item->setData(0, kHeadingRole, parents.isEmpty() ? QString() : heading.text);
      parents << item;
    }
  };
  for (const char* page :
       {"user-guide.md", "keys", "parameters.md", "files.md", "rigs.md", "head.md", "skin-maps.md", "seed-shaders.md"})
    add(QLatin1String(page));
  m_contents->topLevelItem(0)->setExpanded(true);
}

QString GuideWindow::pageText(const QString& page) const {
  if (page == kKeys) return keysPage();
  QFile file(kRoot + page);
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString GuideWindow::keysPage() const {
  QString page = QStringLiteral("# ") + tr("Keyboard shortcuts") + QStringLiteral("\n\n") +
                 tr("As they are set now; *Edit › Keyboard shortcuts* changes them.") + QStringLiteral("\n");
  QString menu;
  for (const Shortcuts::Entry& entry : m_shortcuts.entries()) {
    if (!entry.action || entry.action->shortcut().isEmpty()) continue;
    if (entry.menu != menu) {
      menu = entry.menu;
      page += QStringLiteral("\n## %1\n\n| %2 | %3 |\n|---|---|\n").arg(menu, tr("command"), tr("keys"));
    }
    page += QStringLiteral("| %1 | %2 |\n")
                .arg(entry.label, QKeySequence::listToString(entry.action->shortcuts(), QKeySequence::NativeText));
  }
  return page;
}

void GuideWindow::open(const QString& page, const QString& heading) {
  const QString markdown = pageText(page);
  if (markdown.isEmpty()) {
    m_found->setText(tr("%1 is not part of this guide; it is in the program's source.").arg(page));
    return;
  }
  if (page != m_page || page == kKeys) {
    m_page = page;
    m_text->setMarkdown(markdown);
    // Tables and headings read better with some room.
    for (QTextFrame* frame : m_text->document()->rootFrame()->childFrames())
      if (auto* table = qobject_cast<QTextTable*>(frame)) {
        QTextTableFormat format = table->format();
        format.setCellPadding(5);
        format.setCellSpacing(0);
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderBrush(palette().mid());
        format.setTopMargin(8);
        format.setBottomMargin(12);
        table->setFormat(format);
      }
    for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
      QTextBlockFormat format = block.blockFormat();
      QTextCursor cursor(block);
      if (cursor.currentTable() != nullptr) continue;
      if (format.headingLevel() > 0) format.setTopMargin(format.headingLevel() == 1 ? 4 : 20);
      format.setBottomMargin(block.textList() != nullptr ? 3 : 9);
      cursor.setBlockFormat(format);
    }
  }
  fitPictures();
  showHeading(heading);
}

void GuideWindow::fitPictures() {
  QTextDocument& document = *m_text->document();
  const double room = m_text->viewport()->width() - 2.0 * document.documentMargin();
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
    for (auto it = block.begin(); !it.atEnd(); ++it) {
      QTextImageFormat format = it.fragment().charFormat().toImageFormat();
      if (!format.isValid()) continue;
      const QImage picture(kRoot + format.name());
      if (picture.isNull()) continue;
      const double width = std::min(room, static_cast<double>(picture.width()));
      if (qFuzzyCompare(format.width(), width)) continue;
      format.setWidth(width);
      format.setHeight(width * picture.height() / picture.width());
      // Made as large as it is shown: a text document scales by leaving pixels out.
      QImage fitted =
          picture.scaledToWidth(static_cast<int>(std::lround(width * devicePixelRatioF())), Qt::SmoothTransformation);
      fitted.setDevicePixelRatio(devicePixelRatioF());
      document.addResource(QTextDocument::ImageResource, QUrl(format.name()), fitted);
      QTextCursor cursor(&document);
      cursor.setPosition(it.fragment().position());
      cursor.setPosition(it.fragment().position() + it.fragment().length(), QTextCursor::KeepAnchor);
      cursor.setCharFormat(format);
      break;  // the block's fragments are others now; each of our pictures has a block of its own
    }
}

bool GuideWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_text->viewport() && event->type() == QEvent::Resize)
    QMetaObject::invokeMethod(this, &GuideWindow::fitPictures, Qt::QueuedConnection);
  return QWidget::eventFilter(watched, event);
}

void GuideWindow::showHeading(const QString& heading) {
  QTextCursor top(m_text->document());
  for (QTextBlock block = m_text->document()->begin(); !heading.isEmpty() && block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0 && block.text() == heading) {
      // From the end, so that the heading comes to stand at the top.
      m_text->moveCursor(QTextCursor::End);
      top = QTextCursor(block);
      break;
    }
  m_text->setTextCursor(top);
  m_text->ensureCursorVisible();
}

void GuideWindow::search() {
  const QString words = m_search->text().simplified();
  int pages = 0;
  for (int i = 0; i < m_contents->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = m_contents->topLevelItem(i);
    const bool found = pageText(item->data(0, kPageRole).toString()).contains(words, Qt::CaseInsensitive);
    item->setHidden(!found);
    pages += found ? 1 : 0;
  }
  m_found->setText(words.isEmpty() ? QString() : tr("found on %n page(s)", nullptr, pages));
  if (words.isEmpty() || pages == 0) return;
  m_text->moveCursor(QTextCursor::Start);
  if (m_text->find(words)) return;
  // Not on this page: the first that has it.
  for (int i = 0; i < m_contents->topLevelItemCount(); ++i)
    if (!m_contents->topLevelItem(i)->isHidden()) {
      open(m_contents->topLevelItem(i)->data(0, kPageRole).toString());
      m_text->find(words);
      return;
    }
}

void GuideWindow::findNext() {
  const QString words = m_search->text().simplified();
  if (words.isEmpty() || m_text->find(words)) return;
  m_text->moveCursor(QTextCursor::Start);
  m_text->find(words);
}

}  // namespace dermis
