// SPDX-License-Identifier: MIT OR Apache-2.0
// The plugin in MeshLab's own library: progress, cancel, layers, errors, parameters. filters PLUGINS SCRIPTS PAGE

#include <common/filterscript.h>
#include <common/interfaces.h>
#include <common/pluginmanager.h>
#include <vcg/complex/algorithms/create/platonic.h>

#include <QApplication>
#include <QDir>
#include <QFile>

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

using Clock = std::chrono::steady_clock;

void require(bool holds, const std::string &what) {
    if (!holds) throw std::runtime_error(what);
}

// The callback of MeshLab is a plain function.
int calls, last_percent, cancel_from;
bool is_monotone;
Clock::time_point cancelled;
bool callback(int percent, const char *doing) {
    is_monotone = is_monotone && percent >= last_percent && percent <= 100 && *doing != '\0';
    last_percent = percent;
    ++calls;
    if (percent < cancel_from) return true;
    cancelled = Clock::now();
    return false;
}

class Host {
public:
    explicit Host(const QString &folder) {
        RichParameterList global;
        plugins_.loadPlugins(global, QDir(folder));
        require(plugins_.actionFilterMap.size() == 4, "there are not four filters");
    }

    QStringList names() const { return plugins_.actionFilterMap.keys(); }
    MeshFilterInterface &filter(const QString &name) {
        return *plugins_.stringFilterMap[name];
    }
    RichParameterList parameters(const QString &name, MeshDocument &document) {
        RichParameterList parameters;
        filter(name).initParameterSet(plugins_.actionFilterMap[name], document, parameters);
        return parameters;
    }
    bool run(const QString &name, MeshDocument &document, const RichParameterList &parameters,
             int cancel = 1000) {
        calls = last_percent = 0;
        cancel_from = cancel;
        is_monotone = true;
        const bool is_done = filter(name).applyFilter(plugins_.actionFilterMap[name], document,
                                                      parameters, callback);
        require(is_monotone, "the progress falls back");
        require(is_done == filter(name).errorMsg().isEmpty(), "failures and messages differ");
        return is_done;
    }
    bool run(const QString &name, MeshDocument &document, int cancel = 1000) {
        return run(name, document, parameters(name, document), cancel);
    }

private:
    PluginManager plugins_;
};

const QString surface = "medax: Surface from Points (Power Crust)", axis = "medax: Medial Axis",
              core = "medax: Core", thickness = "medax: Thickness";

/// Points of a torus, as many as asked for, spread by a Fibonacci lattice.
MeshModel &add_torus(MeshDocument &document, int count) {
    MeshModel &layer = *document.addNewMesh("", "torus");
    vcg::tri::Allocator<CMeshO>::AddVertices(layer.cm, count);
    for (int i = 0; i < count; ++i) {
        const double u = 2 * M_PI * std::fmod(i * 0.6180339887498949, 1), v = 2 * M_PI * (i + 0.5) / count;
        const double ring = 1 + 0.4 * std::cos(u);
        layer.cm.vert[i].P() = Point3m(ring * std::cos(v), ring * std::sin(v), 0.4 * std::sin(u));
    }
    layer.UpdateBoxAndNormals();
    return layer;
}

/// Vertices less edges plus triangles of all layers but the first, those at one place being one.
int characteristic(const MeshDocument &document) {
    using Place = std::array<float, 3>;
    std::map<Place, int> number;
    std::set<std::pair<int, int>> edges;
    int faces = 0;
    for (int i = 1; i < document.meshList.size(); ++i) {
        const CMeshO &cm = document.meshList[i]->cm;
        const auto place = [&](const Point3m &p) {
            return number.emplace(Place{p[0], p[1], p[2]}, static_cast<int>(number.size()))
                .first->second;
        };
        const auto edge = [&](int a, int b) { edges.insert(std::minmax(a, b)); };
        for (const CVertexO &vertex : cm.vert) place(vertex.cP());
        for (const CEdgeO &e : cm.edge) edge(place(e.cV(0)->cP()), place(e.cV(1)->cP()));
        for (const CFaceO &face : cm.face) {
            for (int k = 0; k < 3; ++k)
                edge(place(face.cP(k)), place(face.cP((k + 1) % 3)));
            ++faces;
        }
    }
    return static_cast<int>(number.size()) - static_cast<int>(edges.size()) + faces;
}

/// A build that takes its time: short ones call nobody.
void check_progress(Host &host) {
    MeshDocument document;
    add_torus(document, 20000);
    require(host.run(axis, document), host.filter(axis).errorMsg().toStdString());
    require(calls > 3 && last_percent > 50, "there is hardly any progress");
}

void check_layers(Host &host) {
    for (const QString &name : {surface, axis, core}) {
        MeshDocument document;
        MeshModel &torus = add_torus(document, 1500);
        torus.cm.Tr.SetTranslate(1, 2, 3);
        require(host.run(name, document), host.filter(name).errorMsg().toStdString());
        require(document.meshList.size() >= 2, "there is no new layer");
        require(torus.cm.vn == 1500 && torus.cm.fn == 0, "the layer has changed");
        const MeshModel &made = *document.mm();
        require(&made == document.meshList[1], "the new layer is not the current one");
        require(made.cm.Tr == torus.cm.Tr, "the new layer is elsewhere");
        require(name == surface || made.hasDataMask(MeshModel::MM_VERTQUALITY), "no quality");
        require(characteristic(document) == 0, name.toStdString() + " is no torus");
        std::cout << made.label().toStdString() << ": " << made.cm.vn << " vertices, "
                  << made.cm.fn << " faces, " << made.cm.en << " edges\n";
    }
    MeshDocument document;
    add_torus(document, 1500);
    auto both = host.parameters(surface, document);
    both.setValue("shape", BoolValue(true));
    require(host.run(surface, document, both), "no power shape");
    require(document.getMesh(1)->label() == "Power Shape", "the power shape has no layer");
    require(document.mm()->label() == "Power Crust", "the power crust is not current");
    auto extended = host.parameters(core, document);
    extended.setValue("extend", BoolValue(true));
    document.setCurrentMesh(0);
    require(host.run(core, document, extended), "no extended core");
    require(document.mm()->cm.fn > 0, "the core is not extended");
    auto outer = host.parameters(axis, document);
    outer.setValue("side", EnumValue(1));
    document.setCurrentMesh(0);
    require(host.run(axis, document, outer), "no outer axis");
    Box3m room = document.meshList[0]->cm.bbox;
    room.Offset(0.11 * room.Diag());
    require(room.IsIn(document.mm()->cm.bbox.min) && room.IsIn(document.mm()->cm.bbox.max),
            "the outer axis is not clipped");
}

/// Deleted vertices count for nothing, and keep their quality.
void check_thickness(Host &host) {
    MeshDocument document;
    MeshModel &layer = *document.addNewMesh("", "ball");
    vcg::tri::Sphere(layer.cm, 5);
    auto &cm = layer.cm;
    vcg::tri::Allocator<CMeshO>::AddVertices(cm, 2);
    auto &far = cm.vert[cm.vert.size() - 2];
    far.P() = Point3m(50, 0, 0);
    far.Q() = -7;
    vcg::tri::Allocator<CMeshO>::DeleteVertex(cm, far);
    cm.vert.back().P() = Point3m(0, 0, 1);
    layer.UpdateBoxAndNormals();
    for (const bool faces : {true, false}) {
        auto parameters = host.parameters(thickness, document);
        parameters.setValue("faces", BoolValue(faces));
        parameters.setValue("spacing", AbsPercValue(0.1f));
        require(host.run(thickness, document, parameters),
                host.filter(thickness).errorMsg().toStdString());
        double worst = 0;
        for (const CVertexO &vertex : cm.vert)
            if (!vertex.IsD()) worst = std::max(worst, std::abs(vertex.cQ() - 2.0));
        std::cout << "ball by " << (faces ? "faces" : "vertices") << ": thickness wrong by " << worst << '\n';
        // A dense sample of the faces would find the shallow edges between them.
        require(worst < (faces ? 0.1 : 0.001), "the ball has not its thickness");
        require(far.cQ() == -7, "a deleted vertex has got a quality");
    }
    require(document.meshList.size() == 1, "thickness made a layer");
    vcg::tri::Clean<CMeshO>::FlipMesh(cm);
    auto parameters = host.parameters(thickness, document);
    parameters.setValue("faces", BoolValue(true));
    require(!host.run(thickness, document, parameters), "faces that point inward are no error");
    require(host.filter(thickness).errorMsg().contains("point out of it"), "the error does not say why");
    require(cm.vert[0].cQ() > 1, "an error has changed the quality");
}

void check_errors(Host &host) {
    const auto says = [&](const QString &name, const char *text) {
        const std::string message = host.filter(name).errorMsg().toStdString();
        require(message.find(text) != std::string::npos, "'" + message + "' is not '" + text + "'");
    };
    for (const QString &name : host.names()) {
        MeshDocument document;
        require(!host.run(name, document), "no layer, no error");
        says(name, "no current layer");
        MeshModel &layer = add_torus(document, 3);
        for (CVertexO &vertex : layer.cm.vert)
            vcg::tri::Allocator<CMeshO>::DeleteVertex(layer.cm, vertex);
        require(!host.run(name, document), "no vertices, no error");
        says(name, "no vertices");

        MeshDocument other;
        MeshModel &odd = add_torus(other, 100);
        odd.cm.vert[7].P()[1] = std::nanf("");
        require(!host.run(name, other), "NaN is no error");
        says(name, "Vertex 7");
        require(other.meshList.size() == 1, "an error left a layer");
    }
    MeshDocument document;
    add_torus(document, 300);
    auto parameters = host.parameters(axis, document);
    parameters.setValue("theta", FloatValue(90));
    require(!host.run(axis, document, parameters), "90 degrees are no error");
    says(axis, "below 90");
    parameters = host.parameters(core, document);
    parameters.setValue("inside", EnumValue(2));
    require(!host.run(core, document, parameters), "no faces, no error");
    says(core, "no faces");
}

/// A callback that returns false stops the filter soon, wherever it is, and leaves nothing behind.
void check_cancel(Host &host) {
    for (const QString &name : host.names()) {
        for (const int percent : {0, 1, 30, 60}) {
            MeshDocument document;
            add_torus(document, 20000);
            require(!host.run(name, document, percent), "it was not cancelled");
            const auto message = host.filter(name).errorMsg().toStdString();
            require(message.find("cancel") != std::string::npos, message);
            require(document.meshList.size() == 1, "a cancelled filter left a layer");
        }
    }
    MeshDocument document;
    add_torus(document, 200000);
    require(!host.run(axis, document, 5), "it was not cancelled");
    const std::chrono::duration<double> seconds = Clock::now() - cancelled;
    std::cout << "200,000 points, cancelled at " << last_percent << " per cent: back after "
              << seconds.count() << " s\n";
    // medax is back after 0.05 s; other tests may run beside this one.
    require(seconds.count() < 0.5, "the cancel came late");
}

/// The scripts name all parameters, as meshlabserver wants; the page does, too.
void check_texts(Host &host, const QString &scripts, const char *page) {
    std::ostringstream text;
    text << std::ifstream(page).rdbuf();
    for (const QString &file : QDir(scripts).entryList({"*.mlx"})) {
        FilterScript script;
        require(script.open(scripts + "/" + file), "a script cannot be read");
        for (auto &pair : script) {
            MeshDocument document;
            const QString name = pair.filterName();
            require(host.names().contains(name), "a script has an unknown filter");
            const auto parameters = host.parameters(name, document);
            require(parameters.size() == pair.second.size(), "a script lacks parameters");
            require(text.str().find(name.toStdString()) != std::string::npos,
                    "the page lacks " + name.toStdString());
            for (const RichParameter &parameter : parameters) {
                const QString key = parameter.name();
                require(pair.second.hasParameter(key), "a script lacks " + key.toStdString());
                require(text.str().find("`" + key.toStdString() + "`") != std::string::npos,
                        "the page lacks " + key.toStdString());
            }
        }
    }
    require(QDir(scripts).entryList({"*.mlx"}).size() == host.names().size(), "a script is missing");
}

}  // namespace

int main(int argc, char **argv) try {
    QApplication application(argc, argv);
    Host host(argv[1]);
    check_layers(host);
    check_progress(host);
    check_thickness(host);
    check_errors(host);
    check_cancel(host);
    check_texts(host, argv[2], argv[3]);
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
