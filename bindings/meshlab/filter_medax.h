// SPDX-License-Identifier: MIT OR Apache-2.0
#ifndef FILTER_MEDAX_H
#define FILTER_MEDAX_H

#include <common/interfaces.h>

#include <QObject>

/// medax in MeshLab's menus: surfaces, medial axes, cores and thickness of the points of the current layer.
class FilterMedaxPlugin : public QObject, public MeshFilterInterface {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
    Q_INTERFACES(MeshFilterInterface)

public:
    enum { FP_SURFACE, FP_AXIS, FP_CORE, FP_THICKNESS };

    FilterMedaxPlugin();
    ~FilterMedaxPlugin();

    QString pluginName() const override;
    QString filterName(FilterIDType filter) const override;
    QString filterInfo(FilterIDType filter) const override;
    FilterClass getClass(QAction *filter) override;
    int getRequirements(QAction *filter) override;
    int postCondition(QAction *filter) const override;
    FILTER_ARITY filterArity(QAction *filter) const override;
    void initParameterSet(QAction *filter, MeshDocument &document,
                          RichParameterList &parameters) override;
    bool applyFilter(QAction *filter, MeshDocument &document, const RichParameterList &parameters,
                     vcg::CallBackPos *callback) override;

private:
    void surface(MeshDocument &document, const RichParameterList &parameters,
                 vcg::CallBackPos *callback);
    void axis(MeshDocument &document, const RichParameterList &parameters,
              vcg::CallBackPos *callback);
    void core(MeshDocument &document, const RichParameterList &parameters,
              vcg::CallBackPos *callback);
    void thickness(MeshDocument &document, const RichParameterList &parameters,
                   vcg::CallBackPos *callback);
};

#endif
