# One word a task; `make help` lists them.
PREFIX ?= /usr/local
BUILD := $(CURDIR)/build
# The package that the tests use: installed in one place, then moved to another.
STAGED := $(BUILD)/staged
MOVED := $(BUILD)/moved
# The library that counts what settles its predicates, and the test of these counts.
COUNTED := --features count-stages --test predicates
HOST = $(shell rustc -vV | sed -n 's/^host: //p')
CONFIGURE := cmake -S . -B $(BUILD)/medax

.PHONY: help demo test test-rust moved test-package test-hosts test-python test-blender test-meshlab test-manual bench bench-peers bench-nearest peers results medial flow pair field figure3 three-lines convergence stress tsan header doc docs gallery install clean
.DEFAULT_GOAL := help

help:
	@echo 'make demo              sample a shape, make its power crust and medial axis, in out/'
	@echo 'make test              every check and test; installs what they need on Debian'
	@echo 'make test-hosts        Python, Blender, MeshLab, the manual: each tried in the real host; test-python and so on for one'
	@echo 'make bench             how long each stage takes'
	@echo 'make bench-peers       triangulations against those of CGAL, in turns'
	@echo 'make bench-nearest     nearest points of meshes against CGAL'"'"'s AABB tree, in turns'
	@echo 'make results           power crusts of real models against what is known of them: docs/results.md'
	@echo 'make medial            medial axes of real models, tables and pictures: docs/medial.md; needs pyvista'
	@echo 'make flow              cores of real models and smooth shapes, tables and pictures: docs/flow.md; needs pyvista'
	@echo 'make pair              pair-meshes of real models and shapes, a table and pictures: docs/pair.md; needs pyvista'
	@echo 'make field             axes of meshes and figures by the gradient of the distance, tables and pictures: docs/field.md; needs pyvista'
	@echo 'make figure3           seconds against the number of samples, to 4,000,000: docs/scaling.md; takes 14 GB'
	@echo 'make convergence       medial axes against exact ones where samples grow dense: docs/convergence.md'
	@echo 'make stress            triangulations of a million points checked, and fifty builds compared'
	@echo 'make tsan              the threads of triangulations under ThreadSanitizer'
	@echo 'make install PREFIX=   the library, its headers and packages, the program'
	@echo 'make header            write include/medax.h anew from src/capi'
	@echo 'make doc               the Rust documentation, in target/doc'
	@echo 'make docs              the manual with the C reference, in build/manual; gets Sphinx from PyPI'
	@echo 'make gallery           pictures of what parameters do, and the figures of the papers: docs/gallery.md; needs pyvista and pillow'
	@echo 'make clean             remove target/, build/ and out/'

demo:
	@cmake/requirements.sh demo
	cargo build --release --locked
	@cmake/demo.sh out

test:
	@cmake/requirements.sh test
	$(MAKE) --no-print-directory test-rust
	$(MAKE) --no-print-directory test-package

# Formatting, lints, documentation, Rust tests.
test-rust:
	cargo fmt --check
	cargo clippy --locked --all-targets -- -D warnings
	cargo clippy --locked --bench convergence -- -D warnings
	cargo clippy --locked --all-targets --no-default-features -- -D warnings
	cargo clippy --locked $(COUNTED) -- -D warnings
	RUSTDOCFLAGS='-D warnings' cargo doc --locked --no-deps
	cargo test --locked
	for threads in 1 3 8; do MEDAX_THREADS=$$threads cargo test --locked --lib --test structures || exit 1; done
	CARGO_PROFILE_TEST_OPT_LEVEL=0 cargo test --locked $(COUNTED) stages

# The package, installed and moved.
moved:
	$(CONFIGURE) -DCMAKE_INSTALL_PREFIX=$(STAGED)
	cmake --build $(BUILD)/medax
	rm -rf $(STAGED) $(MOVED)
	cmake --install $(BUILD)/medax
	mv $(STAGED) $(MOVED)

# C, C++ against CGAL and OpenMesh, and consumers, all through an installed package that was moved.
test-package: moved
	cmake -S tests -B $(BUILD)/tests -G Ninja -DCMAKE_PREFIX_PATH=$(MOVED) -DMEDAX_TARGET_DIR=$(BUILD)/medax/target
	cmake --build $(BUILD)/tests
	ctest --test-dir $(BUILD)/tests --output-on-failure -j2
	for threads in 1 3 8; do MEDAX_THREADS=$$threads ctest --test-dir $(BUILD)/tests -R cgal.triangulations || exit 1; done

# Where people already work, a part for each host: each in its real host, through the package or a wheel.
HOSTS := python blender meshlab manual
test-hosts: $(addprefix test-,$(HOSTS))

# The wheel, in a fresh virtual environment and away from the sources.
PYTHON := $(BUILD)/python
test-python: moved
	@cmake/requirements.sh test-python
	rm -rf $(PYTHON) bindings/python/build
	python3 -m venv $(PYTHON)/venv
	MEDAX_LIBRARY=$$(find $(MOVED) -name libmedax.so) $(PYTHON)/venv/bin/pip wheel -q --no-deps -w $(PYTHON)/wheel bindings/python
	$(PYTHON)/venv/bin/pip install -q "$$(ls $(PYTHON)/wheel/medax-*.whl)[trimesh,meshio,pyvista,pymeshlab,progress]" -r bindings/python/tests/requirements.txt
	cd $(PYTHON) && venv/bin/auditwheel show wheel/medax-*.whl > audit && grep manylinux_ audit
	cd bindings/python && $(PYTHON)/venv/bin/python generate.py --check && $(PYTHON)/venv/bin/ruff check . && $(PYTHON)/venv/bin/mypy
	cd $(PYTHON) && env -u MEDAX_LIBRARY -u PYTHONPATH MEDAX_TEST_INSTALLED=1 PYTHONDONTWRITEBYTECODE=1 venv/bin/python -X dev -m pytest -q --durations=5 -c $(CURDIR)/bindings/python/pyproject.toml --rootdir $(CURDIR)/bindings/python $(CURDIR)/bindings/python/tests

# Blender itself, as the module bpy for Python 3.11: half a gigabyte, fetched once.
BLENDER := $(BUILD)/blender-venv
$(BLENDER)/ready: bindings/blender/tests/requirements.txt
	@cmake/requirements.sh test-blender
	rm -rf $(BLENDER)
	python3.11 -m venv $(BLENDER)
	$(BLENDER)/bin/pip install -q --disable-pip-version-check -r $<
	touch $@

# The extension with the wheel in it, installed into an empty Blender.
EXTENSION := $(BUILD)/blender
test-blender: moved $(BLENDER)/ready
	@cmake/requirements.sh test-blender
	rm -rf $(EXTENSION) bindings/python/build
	MEDAX_LIBRARY=$$(find $(MOVED) -name libmedax.so) $(BLENDER)/bin/pip wheel -q --no-deps --no-build-isolation -w $(EXTENSION)/wheel bindings/python
	python3.11 bindings/blender/build.py -o $(EXTENSION) $(EXTENSION)/wheel/medax-*.whl
	cd $(EXTENSION) && env -u MEDAX_LIBRARY -u PYTHONPATH EXTENSION=$$(ls $(EXTENSION)/medax-*.zip) PYTHONDONTWRITEBYTECODE=1 $(BLENDER)/bin/python -m pytest -q -p no:cacheprovider --durations=5 $(CURDIR)/bindings/blender/tests

# The plugin, built against Debian's source of MeshLab and run in Debian's MeshLab.
test-meshlab: moved
	@cmake/requirements.sh test-meshlab
	bindings/meshlab/source.sh $(BUILD)/meshlab
	cmake -S bindings/meshlab -B $(BUILD)/meshlab/plugin -G Ninja -DCMAKE_PREFIX_PATH=$(MOVED) -DMESHLAB_SOURCE=$(BUILD)/meshlab/source/src -DFILTER_MEDAX_TESTS=ON
	cmake --build $(BUILD)/meshlab/plugin
	ctest --test-dir $(BUILD)/meshlab/plugin --output-on-failure

# The manual without warnings, and its links.
test-manual: docs
	python3 tests/manual/links.py . $(BUILD)/manual

bench:
	cargo bench --locked

# Against CGAL, on the same points: PEERS='--count 100000 --rounds 5 poles', or files of points.
bench-peers: peers
	$(BUILD)/peers/peers $(PEERS)

# Nearest points of the meshes in MODELS.
bench-nearest: peers
	$(BUILD)/peers/nearest $(NEAREST)

peers:
	@cmake/requirements.sh bench-peers
	$(CONFIGURE) -DCMAKE_INSTALL_PREFIX=$(BUILD)/peers-prefix
	cmake --build $(BUILD)/medax
	cmake --install $(BUILD)/medax
	cmake -S benches/peers -B $(BUILD)/peers -G Ninja -DCMAKE_PREFIX_PATH=$(BUILD)/peers-prefix
	cmake --build $(BUILD)/peers

# From the models in MODELS, a folder.
MODELS ?= ../shared/data
NEAREST ?= --count 50000 $(addprefix $(MODELS)/,fandisk.off rocker-arm.obj foot.off abc_plate_00000329.obj refined_elephant.off igea.ply)
results:
	cargo build --release --locked
	python3 benches/results.py target/release/medax $(MODELS) > results.md.part
	mv results.md.part docs/results.md

medial:
	cargo build --release --locked
	python3 benches/medial.py target/release/medax $(MODELS) docs
	python3 benches/axes.py target/release/medax $(MODELS) docs/axes.png

flow:
	cargo build --release --locked
	python3 benches/flow.py target/release/medax $(MODELS) docs
	python3 benches/cores.py target/release/medax $(MODELS) docs/cores.png

pair:
	cargo build --release --locked
	python3 benches/pair.py target/release/medax $(MODELS) docs

three-lines:
	cargo run --release --locked --example three_lines -- target/xy.ply target/yz.ply target/xz.ply
	python3 benches/three_lines.py target/xy.ply target/yz.ply target/xz.ply docs/three_lines.png

field:
	cargo build --release --locked
	python3 benches/field.py target/release/medax $(MODELS) docs
	python3 benches/balls.py target/release/medax $(MODELS) docs/field.png

# Minutes, and the more exact the less else there is to do for the machine.
figure3:
	cargo build --release --locked
	python3 benches/figure3.py target/release/medax docs

# Minutes; half of it is measuring distances.
convergence:
	cargo bench --locked --bench convergence -- $(abspath $(MODELS)) > convergence.part
	python3 benches/convergence.py convergence.part docs
	rm convergence.part

# Minutes, and some gigabytes.
stress:
	cargo test --locked --release --test stress -- --ignored --nocapture --test-threads 1

# The insertion by several threads under ThreadSanitizer, with a compiler that has it. The standard library is not
# compiled for it, so that what the test harness does with its own threads must be left out.
tsan:
	RUSTC_BOOTSTRAP=1 RUSTFLAGS='-Zsanitizer=thread -Cunsafe-allow-abi-mismatch=sanitizer' \
	TSAN_OPTIONS="suppressions=$(CURDIR)/tests/tsan.supp" \
	cargo test --locked --release --lib --target $(HOST) --target-dir $(BUILD)/tsan parallel

header:
	MEDAX_WRITE_HEADER=1 cargo test --locked --test header_drift

doc:
	RUSTDOCFLAGS='-D warnings' cargo doc --locked --no-deps

# Sphinx, in an environment of its own.
SPHINX := $(BUILD)/sphinx
$(SPHINX)/ready: docs/manual/requirements.txt
	@cmake/requirements.sh docs
	python3 -m venv $(SPHINX)
	$(SPHINX)/bin/pip install --quiet --disable-pip-version-check -r $<
	touch $@

# The pages of docs/ by Sphinx, the C reference by Doxygen; a warning is an error.
docs: $(SPHINX)/ready
	@cmake/requirements.sh docs
	rm -rf $(BUILD)/manual $(BUILD)/doxygen
	doxygen docs/manual/Doxyfile
	PYTHONDONTWRITEBYTECODE=1 $(SPHINX)/bin/sphinx-build -q -E -W --keep-going -b html -d $(BUILD)/doctrees docs $(BUILD)/manual
	mv $(BUILD)/doxygen/html $(BUILD)/manual/c

# Some minutes.
gallery:
	cargo build --release --locked
	python3 benches/parameters.py target/release/medax $(MODELS) docs/gallery
	python3 benches/gallery.py target/release/medax $(MODELS) docs

install:
	@cmake/requirements.sh install
	$(CONFIGURE) -DCMAKE_INSTALL_PREFIX=$(abspath $(PREFIX))
	cmake --build $(BUILD)/medax
	cmake --install $(BUILD)/medax
	cargo build --release --locked --target-dir target
	install -d $(DESTDIR)$(abspath $(PREFIX))/bin
	install -m 755 target/release/medax $(DESTDIR)$(abspath $(PREFIX))/bin/medax

clean:
	rm -rf target build out
