#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/project/project.h"
#include "core/texture/photo/photo.h"
#include "core/texture/photo/photo_preparation.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <memory>

namespace esm {

/// What hangs together with a place of the photo and is to be left out.
struct RegionSeed {
    Eigen::Vector2d place; ///< photo pixels
    double tolerance;      ///< see `growRegion`
};

/// Steps that are to be found in the photo, or by the surface that it is laid on.
struct SoughtSteps : StepsToFind {
    bool match = false;
    std::optional<RegionSeed> region;
    std::optional<Eigen::Vector2d> whiteSpot; ///< of the photo, pixels: grey or white
    std::shared_ptr<const Image> whiteLike;   ///< another photo, which is balanced

    bool soughtWhite() const { return whiteBalance || whiteSpot || whiteLike; }
    bool any() const { return StepsToFind::any() || match || region || soughtWhite(); }
};

/// A layer where it lies.
struct LaidLayer {
    Project project;
    LayerId layer;
};

/// A photo, how it is to be prepared, and what is to be found in it first.
struct PreparationRequest {
    std::shared_ptr<const Photo> photo;
    PhotoPreparation preparation;
    SoughtSteps find;
    std::optional<LaidLayer> laid;      ///< to match the surface beneath; none where that is not sought
    std::shared_ptr<const Image> known; ///< the picture that comes of it, where it is known already
};

/// What became of it.
struct PreparedPhoto {
    int number = 0; ///< of the request, from 1; 0 while there is none
    std::shared_ptr<const Photo> photo;
    PhotoPreparation preparation;         ///< with what was found
    std::shared_ptr<const Image> picture; ///< null where the preparation does nothing
    double highlightShare = 0;            ///< filled, of what is shown, 0 to 1
    QImage before, after;                 ///< small ones, for panels
    QString failure;                      ///< why there is no picture; empty when there is
};

/// Prepares photos on a thread of its own. A request that comes while it works replaces the one it works on.
class PhotoPreparer : public QObject {
    Q_OBJECT

public:
    explicit PhotoPreparer(QObject* parent = nullptr);

    /// Gives the request's number.
    int prepare(PreparationRequest request) { return m_worker.ask(std::move(request)); }
    PreparedPhoto result() const;

signals:
    void prepared();

private:
    LatestWorker<PreparationRequest, PreparedPhoto> m_worker;
};

} // namespace esm
