#pragma once

#include "core/exchange/mesh_file.h"
#include "core/geometry/repair.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QVBoxLayout>

namespace esm {

/// What a mesh file means.
struct ImportChoice {
    LengthUnit unit = LengthUnit::Millimetre;
    UpAxis up = UpAxis::Y;
    KeepParts keep = KeepParts::All;
};

/// The unit in which an organ of this extent has the size of an organ; glTF files are in metres by their
/// standard.
LengthUnit likelyUnit(double largestExtent, const QString& fileEnding);

/// Asks what a mesh file means, showing the size that follows and what was repaired.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    ImportDialog(const QString& fileName, const Eigen::Vector3d& extent, const RepairReport& report,
                 QWidget* parent = nullptr);

    ImportChoice choice() const;

private:
    void addUnits(QVBoxLayout* column, LengthUnit likely);
    void addOrientation(QVBoxLayout* column);
    void addReport(QVBoxLayout* column, const RepairReport& report);
    void showSize();

    Eigen::Vector3d m_extent; ///< in the file's unit and axes
    QButtonGroup* m_units;
    QComboBox *m_up, *m_keep;
    QLabel* m_size;
};

} // namespace esm
