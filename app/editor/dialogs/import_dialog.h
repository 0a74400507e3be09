#pragma once

#include "app/editor/dialogs/imported_surface.h"
#include "core/exchange/meshes/mesh_file.h"
#include "core/model/detail.h"
#include "widgets/inputs/number_field.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QVBoxLayout>

#include <optional>

namespace esm {

/// What a mesh file means.
struct ImportChoice {
    LengthUnit unit = LengthUnit::Millimetre;
    UpAxis up = UpAxis::Y;
    KeepParts keep = KeepParts::All;
    Detail detail;
};

/// Says that no organ has this extent, in a file's unit, and which unit would fit; empty where it may be.
QString doubtfulExtent(double largestExtent, LengthUnit unit);

/// Asks what a mesh file means, showing the size that follows and what was repaired.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// @param largest the largest part alone; needed where the surface has more than one
    ImportDialog(const QString& fileName, const ImportedSurface& all,
                 const std::optional<ImportedSurface>& largest, QWidget* parent = nullptr);

    ImportChoice choice() const;

private:
    void addUnits(QVBoxLayout* column, LengthUnit likely);
    void addOrientation(QVBoxLayout* column);
    void addParts();
    void addDetail(QFormLayout* form);
    void showDetail();
    Detail::Kind detailKind() const { return static_cast<Detail::Kind>(m_detail->currentIndex()); }
    void addReport(QVBoxLayout* column);
    void addButtons(QVBoxLayout* column);
    KeepParts keptParts() const { return m_keep->currentIndex() == 1 ? KeepParts::Largest : KeepParts::All; }
    const ImportedSurface& kept() const;
    QString sizeText(const Eigen::Vector3d& extent) const;
    QStringList partLines() const;
    void showKept();

    ImportedSurface m_all;
    std::optional<ImportedSurface> m_largest;
    QButtonGroup* m_units;
    QComboBox *m_up, *m_keep, *m_detail;
    NumberField* m_nodes;
    double m_fewerNodes; ///< as last asked for
    QLabel *m_size, *m_doubt;
    QPlainTextEdit* m_report;
};

} // namespace esm
