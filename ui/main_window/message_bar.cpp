#include "ui/main_window/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/docks/panel.h"
#include "ui/theme/icons.h"
#include "ui/theme/metrics.h"

namespace dermis {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBar"));
  setProperty("messageBar", true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kGap, metrics::kGap);
  row->setSpacing(metrics::kMargin);
  m_icon = new QLabel(this);
  m_text = new QLabel(this);
  m_text->setObjectName(QStringLiteral("messageBar.text"));
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_text->setTextFormat(Qt::PlainText);
  auto* close = iconButton("close", tr("Close the message"), this);
  row->addWidget(m_icon, 0, Qt::AlignTop);
  row->addWidget(m_text, 1);
  row->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  m_leave.setSingleShot(true);
  connect(&m_leave, &QTimer::timeout, this, &QWidget::hide);
  hide();
}

void MessageBar::showMessage(MessageKind kind, const QString& sentence) {
  if (kind == MessageKind::Warning && isVisible() && !m_leave.isActive()) return;  // an error stands there
  m_icon->setPixmap(themeIcon(kind == MessageKind::Error     ? "error"
                              : kind == MessageKind::Warning ? "warning"
                                                             : "info")
                        .pixmap(16, 16));
  m_text->setText(sentence);
  m_text->setAccessibleName(sentence);
  setAccessibleName(sentence);
  m_leave.stop();
  if (kind != MessageKind::Error) m_leave.start(6000);
  // Read out at once: nobody who doesn't see it looks here by himself. A second sentence comes up as the first did.
  hide();
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

QString MessageBar::message() const { return isVisible() ? m_text->text() : QString(); }

}  // namespace dermis
