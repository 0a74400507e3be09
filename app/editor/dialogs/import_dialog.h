#pragma once

#include "app/editor/dialogs/body_question.h"
#include "app/editor/dialogs/opening_options.h"
#include "app/editor/workers/surface_importer.h"
#include "core/exchange/meshes/mesh_file.h"
#include "widgets/view/organ_view.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace esm {

/// What a mesh file means.
struct ImportChoice {
    LengthUnit unit = LengthUnit::Millimetre;
    UpAxis up = UpAxis::Y;
    KeepParts keep = KeepParts::All;
    double slitWidth = 0;      ///< m, up to which slits are closed
    std::size_t holeEdges = 0; ///< up to which holes are filled
    BodyChoice body;
};

/// In metres.
RepairOptions repairOptions(const ImportChoice& choice);

/// Asks what a mesh file means and shows what follows: the surface in space with its open borders, its size,
/// what was repaired. Another choice is worked out beside the window.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param found what the soup is without more repairs than are always made
    ImportDialog(const QString& fileName, std::shared_ptr<const PolygonSoup> soup,
                 std::shared_ptr<const ImportedSurface> found, QWidget* parent = nullptr);

    ImportChoice choice() const;
    /// Asks again what was answered before, where that could not be done.
    int exec() override;
    /// Ends what is still worked out, which may take a moment; on any thread, once the dialog was answered
    /// for good.
    void stopWork() { m_importer.stop(); }
    /// Not while a number in it is refused.
    void accept() override;
    void done(int result) override;

private:
    QVBoxLayout* makePicture();
    QWidget* makeQuestions(const QString& fileName);
    void addUnits(QVBoxLayout* column, LengthUnit likely);
    void addOrientation(QVBoxLayout* column);
    void addParts();
    void showWhetherPossible();
    void addReport(QVBoxLayout* column);
    void addButtons(QVBoxLayout* column);
    KeepParts keptParts() const { return m_keep->currentIndex() == 1 ? KeepParts::Largest : KeepParts::All; }
    void lookAgain();
    void takeAnswer();
    void showPreview(const RenderScene& preview);
    QString sizeText(const Eigen::Vector3d& extent) const;
    QStringList partLines() const;
    void showKept();

    std::shared_ptr<const ImportedSurface> m_found, m_shown;
    SurfaceImporter m_importer;
    bool m_isAnswered = false; ///< by the user
    int m_answer = 0;          ///< number of the latest that was looked at
    OrganView* m_view;
    OpeningOptions* m_openings;
    QButtonGroup* m_units;
    QComboBox *m_up, *m_keep;
    BodyQuestion* m_body;
    QLabel *m_size, *m_doubt;
    QPlainTextEdit* m_report;
    QPushButton* m_accept;
};

} // namespace esm
