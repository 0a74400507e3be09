#pragma once

#include "app/editor/document/document.h"
#include "app/editor/document/selection.h"
#include "app/editor/workers/placement_refiner.h"
#include "app/editor/workers/pose_finder.h"

namespace esm {

/// The landmarks of the selected photo while they are being set: which of them is selected, which is only
/// half set, and the pose that they come to. Setting, moving and removing one places the photo anew, as part
/// of that one step, as soon as there are enough of them.
class Landmarking : public QObject {
    Q_OBJECT

public:
    /// A pair of which only one point is known yet.
    struct Half {
        std::optional<Eigen::Vector2d> photo; ///< pixels
        std::optional<Eigen::Vector3d> organ; ///< m
        bool isBegun() const { return photo || organ; }
    };

    Landmarking(Document& document, Selection& selection, QObject* parent = nullptr);

    /// The selected photo's layer; null without one.
    const TextureLayer* layer() const;
    const std::vector<LandmarkPair>& pairs() const;
    const Half& half() const { return m_half; }
    /// Of the pairs as they are; null where there is none, or it is still being sought.
    const PoseFit* fit() const;
    /// Why the pairs give no pose; empty where they do, are too few, or it is still being sought.
    QString failure() const;
    /// Whether what was asked last is still without an answer.
    bool isSeeking() const { return m_asked && !(m_answer && m_answer->question == *m_asked); }
    /// Whether the photo stands elsewhere than the pairs say.
    bool isElsewhere() const;

    std::optional<std::size_t> selected() const { return m_selected; }
    void select(std::optional<std::size_t> pair);

    void pickPixel(const Eigen::Vector2d& pixel);
    void pickPoint(const Eigen::Vector3d& point);
    /// Moves a point of a pair, or of the half one after the last; moves that follow each other are one step.
    void movePixel(std::size_t pair, const Eigen::Vector2d& pixel);
    void movePoint(std::size_t pair, const Eigen::Vector3d& point);
    void finishMove();
    /// Puts back what moved since the last finishMove(), the photo included. Nothing of it stays to be
    /// undone.
    void dropMove();
    void remove(std::size_t pair);
    void replace(std::vector<LandmarkPair> pairs);
    /// Forgets a half pair.
    void giveUpHalf();
    /// Places the photo by the pose that was found.
    void place();

    /// Moves the photo to where it agrees best with the other layers; a moment later, as one step.
    void refine();
    /// Whether there are other layers that it may agree with.
    bool mayRefine() const { return !others().empty(); }
    bool isRefining() const { return m_refining.has_value(); }
    /// What refining came to, for as long as the photo stays there; null before.
    const PoseRefinement* refinement() const;
    /// Whether the photo was last refined in vain, and stands where it stood then.
    bool wasRefinedInVain() const;

signals:
    void changed();

private:
    /// What an edit asked for: where the pairs come to a pose, it becomes part of the edit.
    struct Wanted {
        std::vector<LandmarkPair> pairs;
        QString text;
        MergeKey mergeKey;
    };

    /// What a move began with.
    struct Before {
        LayerId photo;
        std::vector<LandmarkPair> pairs;
        Projector projector;
    };

    void follow();
    void beginMove();
    PoseQuestion question() const;
    const PoseAnswer* answer() const;
    void completeHalf();
    void edit(const QString& text, const std::function<void(std::vector<LandmarkPair>&)>& change);
    void takeAnswer();
    std::vector<TextureLayer> others() const;
    void takeRefinement();
    void placeBy(const PoseFit& fit, const QString& text, const MergeKey& mergeKey);

    Document& m_document;
    Selection& m_selection;
    PoseFinder m_finder;
    std::optional<PoseQuestion> m_asked;
    std::shared_ptr<const PoseAnswer> m_answer;
    std::optional<Wanted> m_wanted;
    PlacementRefiner m_refiner;
    std::optional<std::pair<LayerId, Projector>> m_refining, m_inVain; ///< which photo, and where it stood
    std::optional<PoseRefinement> m_refinement;
    std::optional<Before> m_before; ///< while a pair moves
    std::optional<LayerId> m_photo;
    std::optional<std::size_t> m_selected;
    Half m_half;
    int m_gesture = 0;
};

/// The projector that a fit found, in all that landmarks do not say as it was.
Projector placedBy(const PoseFit& fit, const Projector& before);

} // namespace esm
