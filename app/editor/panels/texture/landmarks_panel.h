#pragma once

#include "app/editor/tools/landmarking.h"
#include "widgets/inputs/item_list.h"
#include "widgets/inputs/section.h"

#include <QPushButton>

namespace esm {

/// The points that the selected photo shares with the organ, how well they agree, and what comes of them.
class LandmarksPanel : public Section {
    Q_OBJECT

public:
    explicit LandmarksPanel(Landmarking& landmarking, QWidget* parent = nullptr);

    /// What the button "Set" does: it takes the tool in hand.
    void setToolAction(QAction* action);

private:
    void layOut();
    void show();
    void showRows();
    void showResult();
    void showUse();
    void removeSelected();
    void load();
    void save();
    void showRemark();
    QString state() const;
    QString doubt() const;

    Landmarking& m_landmarking;
    QLabel *m_count, *m_error, *m_sure, *m_focalLength, *m_lineOfSight, *m_pixels, *m_remark;
    ItemList* m_list;
    QToolButton *m_tool, *m_remove;
    QPushButton *m_place, *m_load, *m_save, *m_refine;
};

} // namespace esm
