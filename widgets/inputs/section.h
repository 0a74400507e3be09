#pragma once

#include <QFormLayout>
#include <QFrame>
#include <QLabel>
#include <QStackedWidget>
#include <QToolButton>
#include <QVariant>
#include <QVBoxLayout>

namespace esm {

/// One section of a side panel: a small quiet title, an optional action at its right, the content beneath and
/// a line below.
class Section : public QFrame {
    Q_OBJECT

public:
    explicit Section(const QString& title, QWidget* parent = nullptr);

    void setTitle(const QString& title);
    /// Adds a widget at the right of the title.
    void addToHeader(QWidget* widget);
    /// A quiet text button at the right of the title.
    QToolButton* addHeaderButton(const QString& text, const QString& toolTip);
    /// The same with an icon in place of the text.
    QToolButton* addHeaderIcon(const QIcon& icon, const QString& name);
    QVBoxLayout* body() const { return m_body; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fitTitle();

    QString m_fullTitle;
    QLabel* m_title;
    QHBoxLayout* m_header;
    QVBoxLayout* m_body;
};

/// Rows of a quiet caption at the left and a value or field at the right.
class ValueRows : public QWidget {
    Q_OBJECT

public:
    explicit ValueRows(QWidget* parent = nullptr);

    /// A right-aligned text that can be selected and copied, as long as its own caption leaves room; `name`
    /// finds it in tests.
    QLabel* addText(const QString& caption, const QString& name);
    void addField(const QString& caption, QWidget* field);
    /// A row for either of two fields with their captions, the first at first.
    void addEither(const QString& caption, QWidget* field, const QString& otherCaption, QWidget* other);
    /// Of such a row.
    void showField(QWidget* field);
    /// A field that needs the whole width, beneath its caption.
    void addWideField(const QString& caption, QWidget* field);

private:
    QLabel* captionOf(const QString& caption, QWidget* field);
    QLabel* captionBeside(const QString& caption, QWidget* field);

    QFormLayout* m_form;
};

} // namespace esm
