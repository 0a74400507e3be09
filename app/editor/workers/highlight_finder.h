#pragma once

#include "app/editor/workers/latest_worker.h"
#include "core/texture/photo/photo.h"
#include "core/texture/photo/photo_preparation.h"

#include <QImage>
#include <QObject>

#include <memory>

namespace esm {

/// Shows what a preparation would fill as highlights, on a thread of its own: the mask follows a slider.
class HighlightFinder : public QObject {
    Q_OBJECT

public:
    explicit HighlightFinder(QObject* parent = nullptr);

    /// @param preparation whose field, strokes and highlights count
    void find(std::shared_ptr<const Photo> photo, const PhotoPreparation& preparation);
    /// Of the photo's size, transparent where nothing is filled; null while nothing was found of this photo.
    QImage maskOf(const std::shared_ptr<const Photo>& photo) const;

signals:
    void found();

private:
    struct Question {
        std::shared_ptr<const Photo> photo;
        PhotoPreparation preparation;
    };

    struct Found {
        std::weak_ptr<const Photo> photo;
        QImage mask;
    };

    LatestWorker<Question, Found> m_worker;
};

} // namespace esm
