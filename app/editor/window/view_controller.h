#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/window/theme.h"
#include "app/editor/workers/moving_photo.h"
#include "app/editor/workers/preview.h"
#include "app/editor/workers/texture_composer.h"
#include "core/render/view_state.h"
#include "widgets/view/organ_view.h"

#include <QTimer>

#include <initializer_list>

namespace esm {

struct Actions;

/// What the view shows: it comes from document, selection, preview and composed texture.
class ViewController : public QObject {
    Q_OBJECT

public:
    ViewController(OrganView& view, Document& document, Selection& selection, Preview& preview);

    void connectActions(const Actions& actions);
    void setTheme(Theme theme);
    /// Where it is cut while it is cut open.
    void setCut(const Cut& cut);
    /// A moment of another motion in place of the one that plays; none: what plays.
    void showMoment(std::optional<PreviewFrame> moment);

signals:
    /// Photos or paint were edited while none of them is shown.
    void unseenEdit();
    void message(const QString& text);
    /// How far the photos are redrawn, where that takes long; empty when they are.
    void redrawing(const QString& text);
    /// That they were, and how long it took.
    void redrawn(const QString& text);
    /// Why the photos are not on the organ; empty when they are.
    void pictureFailed(const QString& reason);

private:
    /// The nodes of the region that is marked in the picture.
    struct Mark {
        std::shared_ptr<const SpringNetwork> network;
        Region region;
        std::shared_ptr<const std::vector<double>> weights; ///< per node
    };

    void followDocument(const Change& change);
    void takeTissue();
    void connectShownParts(const Actions& actions);
    void followCamera();
    void composePhotos();
    void expectPhotos();
    void announceRedrawing();
    void endRedrawing();
    /// Makes the picture anew.
    void rebuildScene();
    /// Makes some parts of it anew.
    using Part = void (ViewController::*)(RenderScene& scene);
    void rebuild(std::initializer_list<Part> parts);
    void dressOrgan(RenderScene& scene);
    void showEllipsoids(RenderScene& scene);
    void markRegion(RenderScene& scene);
    void showProjector(RenderScene& scene);
    void showShownParts(RenderScene& scene);
    void colourTissue(RenderScene& scene);
    void showFixedNodes(RenderScene& scene);
    void paintBackground(RenderScene& scene);
    PreviewFrame frameNow();
    void showFrame();
    void showTexture();

    OrganView& m_view;
    Document& m_document;
    Selection& m_selection;
    Preview& m_preview;
    TextureComposer m_composer;
    MovingPhoto m_moving{m_composer};
    Theme m_theme = Theme::Dark;
    QTimer m_redrawing; ///< runs while the photos are redrawn
    bool m_textureWorkspace = false, m_showsProjector = true;
    bool m_isBare = false;                       ///< without photos and paint
    ViewState m_state;                           ///< as the user wants it
    Cut m_cut;                                   ///< while it is cut open
    std::shared_ptr<const TissueModel> m_tissue; ///< as it was evaluated last
    std::optional<PreviewFrame> m_moment;        ///< in place of what plays
    std::vector<double> m_speeds;                ///< m/s, one per node, of the latest frame
    std::optional<ValueRange> m_colourRange;     ///< of what is coloured
    std::vector<std::uint32_t> m_fixedNodes;
    Mark m_mark;
};

} // namespace esm
