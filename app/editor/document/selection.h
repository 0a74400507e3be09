#pragma once

#include "app/editor/document/change.h"

#include <QObject>

#include <cstddef>
#include <optional>

namespace esm {

class Document;

/// Which region and which photo the window speaks of. Not part of the project, and no edit.
class Selection : public QObject {
    Q_OBJECT

public:
    explicit Selection(Document& document);

    /// Index into the project's regions; none is the whole organ's base tissue.
    std::optional<std::size_t> region() const { return m_region; }
    void setRegion(std::optional<std::size_t> region);
    /// Index into the project's photos.
    std::optional<std::size_t> photo() const { return m_photo; }
    void setPhoto(std::optional<std::size_t> photo);

signals:
    void changed();

private:
    void followDocument(const Change& change);

    Document& m_document;
    std::optional<std::size_t> m_region, m_photo;
    std::size_t m_regionCount, m_photoCount;
};

} // namespace esm
