#include "widgets/inputs/section.h"

#include "widgets/inputs/action_texts.h"

#include <QEvent>

namespace esm {

Section::Section(const QString& title, QWidget* parent)
    : QFrame(parent), m_title(new QLabel(this)), m_header(new QHBoxLayout), m_body(new QVBoxLayout) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 10, 12, 14);
    column->setSpacing(8);
    m_title->setObjectName(QStringLiteral("sectionTitle"));
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_title->setMinimumHeight(22);
    m_title->installEventFilter(this);
    m_header->addWidget(m_title, 1);
    m_header->setSpacing(4);
    column->addLayout(m_header);
    m_body->setSpacing(6);
    column->addLayout(m_body);
    setTitle(title);
}

void Section::setTitle(const QString& title) {
    m_fullTitle = title;
    m_title->setToolTip(title);
    fitTitle();
}

void Section::fitTitle() {
    m_title->setText(m_title->fontMetrics().elidedText(m_fullTitle, Qt::ElideRight, m_title->width()));
}

bool Section::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_title && event->type() == QEvent::Resize) fitTitle();
    return QFrame::eventFilter(watched, event);
}

void Section::addToHeader(QWidget* widget) {
    m_header->addWidget(widget);
}

QToolButton* Section::addHeaderButton(const QString& text, const QString& toolTip) {
    auto* button = new QToolButton(this);
    button->setText(text);
    button->setToolTip(toolTip);
    button->setAccessibleName(toolTip);
    button->setObjectName(QStringLiteral("headerButton"));
    button->setFocusPolicy(Qt::TabFocus);
    addToHeader(button);
    return button;
}

QToolButton* Section::addHeaderIcon(const QIcon& icon, const QString& name) {
    QToolButton* button = addHeaderButton({}, name);
    button->setIcon(icon);
    button->setIconSize({16, 16});
    button->setProperty("iconOnly", true);
    return button;
}

ValueRows::ValueRows(QWidget* parent) : QWidget(parent), m_form(new QFormLayout(this)) {
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(12);
    m_form->setVerticalSpacing(6);
    m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

QLabel* ValueRows::addText(const QString& caption, const QString& name) {
    auto* text = new QLabel(this);
    text->setObjectName(name);
    text->setProperty("value", true);
    text->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout;
    row->setSpacing(m_form->horizontalSpacing());
    row->addWidget(captionBeside(caption, text));
    row->addWidget(text, 1);
    m_form->addRow(row);
    return text;
}

QLabel* ValueRows::captionOf(const QString& caption, QWidget* field) {
    auto* label = new QLabel(caption, this);
    label->setProperty("quiet", true);
    label->setBuddy(field);
    if (field->accessibleName().isEmpty()) field->setAccessibleName(withoutMnemonic(caption));
    return label;
}

QLabel* ValueRows::captionBeside(const QString& caption, QWidget* field) {
    QLabel* label = captionOf(caption, field);
    label->setMinimumHeight(field->minimumSizeHint().height());
    return label;
}

void ValueRows::addField(const QString& caption, QWidget* field) {
    m_form->addRow(captionBeside(caption, field), field);
}

void ValueRows::addEither(const QString& caption, QWidget* field, const QString& otherCaption,
                          QWidget* other) {
    auto* captions = new QStackedWidget(this);
    auto* fields = new QStackedWidget(this);
    for (const auto& [text, shown] : {std::pair(caption, field), std::pair(otherCaption, other)}) {
        captions->addWidget(captionBeside(text, shown));
        fields->addWidget(shown);
    }
    connect(fields, &QStackedWidget::currentChanged, captions, &QStackedWidget::setCurrentIndex);
    m_form->addRow(captions, fields);
}

void ValueRows::showField(QWidget* field) {
    auto* fields = qobject_cast<QStackedWidget*>(field->parentWidget());
    if (fields) fields->setCurrentWidget(field);
}

void ValueRows::addWideField(const QString& caption, QWidget* field) {
    m_form->addRow(captionOf(caption, field));
    m_form->addRow(field);
}

} // namespace esm
