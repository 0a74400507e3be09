#pragma once

#include "app/editor/window/view_controller.h"
#include "app/editor/workers/poke_test.h"
#include "widgets/view/view_caption.h"

namespace esm {

/// Where the motion of a poke is watched: in the view, in place of the living organ, and beside it what it
/// was before, seen from the same side.
class PokeScreen : public QObject {
    Q_OBJECT

public:
    PokeScreen(OrganView& view, ViewController& controller, Preview& preview, PokeTest& test);

    /// Stands at the left of the view while there is something to compare with.
    QWidget& formerView() { return *m_former; }
    void connectActions(const Actions& actions);
    /// Asks where to write the motion as a film, seen as in the view, and writes it.
    void saveFilm(const Document& document);

signals:
    /// Something for the line at the bottom.
    void message(const QString& text);

private:
    void show();
    void enter();
    void leave();
    void showFormer(const PokeMotion& motion);
    void followCamera(OrganView& from, OrganView& to);

    OrganView& m_view;
    OrganView* m_former;
    ViewController& m_controller;
    Preview& m_preview;
    PokeTest& m_test;
    ViewCaption* m_caption;
    std::function<void()> m_takeLook;   ///< in hand: nothing that is shown can be touched
    std::optional<bool> m_playedBefore; ///< the living organ, while a motion is watched
    bool m_isFollowing = false;         ///< one camera the other
};

} // namespace esm
