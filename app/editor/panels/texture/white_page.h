#pragma once

#include "app/editor/edits/preparation_edits.h"

#include <QComboBox>
#include <QPushButton>

namespace esm {

/// What stands above a photo while its white is balanced: found, by a spot that is clicked, or as in another
/// photo.
class WhitePage : public QWidget {
    Q_OBJECT

public:
    WhitePage(Document& document, PreparationEdits& edits, QWidget* parent = nullptr);

    void pick(const Eigen::Vector2d& place);
    void showBalance(); ///< as it is by now, and the photos there are

private:
    void takeFromAnother();

    Document& m_document;
    PreparationEdits& m_edits;
    QPushButton *m_find, *m_take, *m_none;
    QComboBox* m_others;
};

} // namespace esm
