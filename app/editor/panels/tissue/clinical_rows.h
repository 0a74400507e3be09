#pragma once

#include "widgets/inputs/number_field.h"

#include <QWidget>

namespace esm {

/// Tissue in units that clinicians know, both ways: Young's modulus, which follows from the spring constant
/// and the wall's thickness, and the relaxation time, viscosity over spring constant. What is typed is
/// announced as it was typed.
class ClinicalRows : public QWidget {
    Q_OBJECT

public:
    explicit ClinicalRows(QWidget* parent = nullptr);

    /// What tissue is set to; none where a region leaves it to what lies beneath.
    struct Tissue {
        std::optional<double> springConstant; ///< N/m
        std::optional<double> relaxationTime; ///< s
        double wallThickness;                 ///< m
    };
    void setTissue(const Tissue& tissue);
    /// The wall's thickness is the whole organ's.
    void showWallThickness(bool isShown);

signals:
    void youngsModulusEdited(double pascal);
    void relaxationTimeEdited(double seconds);
    void wallThicknessEdited(double metres);
    /// What follows is another edit.
    void gestureFinished();

private:
    NumberField *m_modulus, *m_relaxation, *m_thickness;
    QWidget* m_wall;
};

} // namespace esm
