#pragma once

#include "app/editor/tools/landmarking.h"
#include "app/editor/window/actions.h"
#include "widgets/view/organ_view.h"
#include "widgets/view/photo_view.h"

namespace esm {

/// Between landmarks, the organ's view and the photo's, which stands above it while the tool is in hand.
class LandmarkController : public QObject {
    Q_OBJECT

public:
    LandmarkController(OrganView& organ, PhotoView& photo, Landmarking& landmarking);

    void connectActions(const Actions& actions);

private:
    void connectViews();
    void show();
    void showTool(ViewTool tool);
    QString nextStep() const;

    OrganView& m_organ;
    PhotoView& m_photo;
    Landmarking& m_landmarking;
};

} // namespace esm
