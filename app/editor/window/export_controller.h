#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/pulled_scene.h"
#include "core/exchange/simulators/exporters.h"

#include <QObject>
#include <QWidget>

namespace esm {

class PokeTest;

/// Hands the organ over to other programs, after saying what will differ there.
class ExportController : public QObject {
    Q_OBJECT

public:
    ExportController(QWidget& window, Document& document);

    /// The poke that was recorded last can be tried in other programs. @param poke outlives this
    void offerPoke(const PokeTest& poke) { m_poke = &poke; }
    /// Asks for the file and its kind.
    void choose();
    /// In the format that the file's ending says; the first there is where it says none.
    /// @param pictures how the texture is stored, where the format holds one
    void exportTo(const std::filesystem::path& file, const PictureEncoding& pictures = {});

signals:
    /// Another program can read this file or folder now.
    void exported(const QString& file);

private:
    /// Nothing where the user gives up.
    std::optional<EngineSettings> askedSettings(const Handover& handover, const Exporter& exporter);

    TriedMotion triedMotion(const Handover& handover) const;

    QWidget& m_window;
    Document& m_document;
    const PokeTest* m_poke = nullptr;
};

} // namespace esm
