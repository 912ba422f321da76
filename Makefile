# Near and Far: the one entry point. `make help` lists every target.
#
#   MARCH=native   the processor to build for (x86-64 for any PC)
#   BUILD=build    where everything generated goes
#   WERROR=-Werror warnings stop the build, as they do in CI
#   TESTS="..."    the folders of tests/ to run, if not all
#   V=1            shows every command

MARCH  ?= native
BUILD  ?= build
WERROR ?=
LUA    := texlua

# A rule says what it makes, or with V=1 how.
Q   := $(if $(V),,@)
say  = @echo "$(1) $@"

# The plainest processor of this machine's family.
plainest := $(if $(filter x86_64,$(shell uname -m)),x86-64,native)

# The C++ compiler that goes with the C compiler.
ifeq ($(origin CXX),default)
CXX := $(subst clang,clang++,$(subst gcc,g++,$(patsubst cc,c++,$(CC))))
endif

override CFLAGS := -std=c17 -O3 -march=$(MARCH) -ffp-contract=off \
	-fopenmp -Wall -Wextra -Wpedantic -Wno-missing-field-initializers \
	$(WERROR) $(CFLAGS)
comma    := ,
CXXFLAGS  = $(patsubst -std=c17,-std=c++17,$(CFLAGS))
CPPFLAGS := -Icode -D_GNU_SOURCE -MMD -MP
LDLIBS   := -lm

# ---- what there is -------------------------------------------------
chapters  := $(patsubst code/ch%,%,$(wildcard code/ch*))
modules     := $(wildcard code/*.c code/common/*.c code/ch*/*.c)
clients     := $(wildcard code/ch*/experiments/*.c code/near/*.c code/range/*.c code/contact/*.c code/peers/*.c)
sources     := $(modules) $(clients)
# What has no .h is a program; the rest is shared by programs and tests.
shared      := $(foreach c,$(clients),$(if $(wildcard $(c:.c=.h)),$(c)))
mains       := $(filter-out $(shared) code/near/% code/range/% code/contact/% code/peers/%,$(clients))
chapter_of   = ch$(firstword $(subst -, ,$(patsubst code/ch%,%,$(1))))
program_of   = $(BUILD)/$(call chapter_of,$(1))/$(basename $(notdir $(1)))
programs    := $(BUILD)/near $(BUILD)/range $(BUILD)/contact $(foreach c,$(mains),$(call program_of,$(c)))

# gnuplot wants to know that degrees and dashes are written in UTF-8.
export LC_ALL = C.UTF-8

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:

#: the book and every program (the default)
all: $(programs) $(BUILD)/near-and-far.pdf

#: every program, without the book
programs: $(programs)

# ---- set-up --------------------------------------------------------
# Each stamp says that the tools for one kind of work are there.
$(BUILD)/setup/%: setup
	@CC="$(CC)" CXX="$(CXX)" ./setup $*
	@mkdir -p $(@D) && touch $@

# A level of tools stands on the one before.
$(BUILD)/setup/test: | $(BUILD)/setup/code
$(BUILD)/setup/book: | $(BUILD)/setup/test
$(BUILD)/setup/web: | $(BUILD)/setup/book
$(BUILD)/setup/check-web: | $(BUILD)/setup/web
$(BUILD)/setup/check: | $(BUILD)/setup/test
$(BUILD)/setup/peers: | $(BUILD)/setup/code
$(BUILD)/setup/arm64: | $(BUILD)/setup/code
$(BUILD)/setup/evidence: | $(BUILD)/setup/code

# Other flags, another compiler: everything is compiled anew.
flags := $(CC) $(CXX) $(filter-out -Werror,$(CPPFLAGS) $(CFLAGS))
ifeq ($(filter help clean,$(MAKECMDGOALS)),)
ifneq ($(flags),$(shell cat $(BUILD)/flags 2>/dev/null))
$(shell mkdir -p $(BUILD) && echo '$(flags)' > $(BUILD)/flags)
endif
endif

# ---- modules -------------------------------------------------------
object_of = $(patsubst code/%.c,$(BUILD)/plain/%.o,$(1))

$(BUILD)/plain/%.o: code/%.c $(BUILD)/flags | $(BUILD)/setup/code
	@mkdir -p $(@D)
	$(call say,compile)
	$(Q)$(CC) $(CPPFLAGS) $(CFLAGS) -c $< -o $@

# A table of measurements says with which flags it was made.
$(BUILD)/plain/common/report.o: CPPFLAGS += -DBUILD_FLAGS='"$(CFLAGS)"'

# Numbers are read and written by the C++ library, or where that cannot
# be had by the C library, which takes longer. The file says which: it
# holds what to link with, if anything.
charconv := $(BUILD)/charconv
needed   := $(if $(filter Darwin,$(shell uname)),,-Wl$(comma)--as-needed)
$(charconv): code/common/charconv.cc $(BUILD)/flags | $(BUILD)/setup/code
	@echo 'char *number_to_text(char *, double);' \
	    'int main(void) { char text[40]; number_to_text(text, 1); }' >$@.c
	@if { $(CXX) -Icode $(CXXFLAGS) -c $< -o $@.o && \
	    $(CC) $(CFLAGS) $@.c $@.o -o $@.try -lstdc++; } >$@.log 2>&1; \
	then echo $(needed) -lstdc++; fi >$@.new; mv $@.new $@

$(BUILD)/plain/common/numbers.o: code/common/numbers.c code/common/charconv.cc $(charconv)
	@mkdir -p $(@D)
	$(call say,compile)
	$(Q)if [ -s $(charconv) ]; \
	then $(CXX) $(CPPFLAGS) $(CXXFLAGS) -c code/common/charconv.cc -o $@; \
	else $(CC) $(CPPFLAGS) $(CFLAGS) -c $< -o $@; fi

# The modules are one library, what programs share is another. Both are
# thin, lists of objects, where ar can make such; each program takes
# from them what it uses.
libraries := $(BUILD)/libshared.a $(BUILD)/libnear.a
thin      := $(if $(filter Darwin,$(shell uname)),,T)
$(BUILD)/libnear.a: $(call object_of,$(modules))
$(BUILD)/libshared.a: $(call object_of,$(shared))
$(libraries):
	$(call say,collect)
	@rm -f $@
	$(Q)$(AR) qcs$(thin) $@ $^

# Program $(1) of the objects $(2), with $(3) besides. The linker tells
# which objects of the libraries it took, and from then on the program
# waits for these, and no longer for all.
define link_rule
$(1): $(2) $(charconv) $(if $(wildcard $(1).d),|) $(libraries)
	@mkdir -p $$(@D)
	$$(call say,link)
	$$(Q)$$(CC) $$(CFLAGS) $(2) $$(libraries) -o $$@ $(3) $$(LDLIBS) \
		@$(charconv) -Wl,-t >$$@.taken
	@awk -v program=$$@ -v own=' $(strip $(2)) ' -v plain=$(BUILD)/plain/ \
		'index($$$$0, plain) == 1 && !index(own, " " $$$$0 " ") \
		{ print program ": " $$$$0 "\n" $$$$0 ":" }' $$@.taken >$$@.d
	@rm $$@.taken; test -s $$@.d || rm $$@.d
endef
$(eval $(call link_rule,$(BUILD)/near,$(BUILD)/plain/near/near.o))
$(eval $(call link_rule,$(BUILD)/range,$(BUILD)/plain/range/range.o))
$(eval $(call link_rule,$(BUILD)/contact,$(BUILD)/plain/contact/contact.o))
$(foreach c,$(mains),$(eval $(call link_rule,$(call program_of,$(c)),$(call object_of,$(c)))))

# ---- tests ---------------------------------------------------------
test_folders  := $(sort $(notdir $(patsubst %/,%,$(dir $(wildcard tests/*/*.c)))))
# The longest first, or one would be left alone with a processor.
longest       := exercises press sheet corpus grade release manual instructions ch11-crowds
all_tests     := $(filter-out web browser,$(patsubst tests/%/.,%,$(wildcard tests/*/.)))
TESTS         ?= $(filter $(all_tests),$(longest)) $(filter-out $(longest),$(all_tests))
test_programs := $(test_folders:%=$(BUILD)/tests/%)

$(BUILD)/plain/tests/%.o: tests/%.c $(BUILD)/flags | $(BUILD)/setup/code
	@mkdir -p $(@D)
	$(call say,compile)
	$(Q)$(CC) $(CPPFLAGS) -Itests $(CFLAGS) -c $< -o $@

# Vector code whose instructions are emulated by SIMDe: its lanes wrap
# around as signed numbers, its casts look at one vector as another, and
# it is to be tested on every machine as on the plainest.
emulated := $(patsubst %.c,$(BUILD)/plain/%.o,$(wildcard tests/instructions/*.c))
$(emulated): tests/instructions/emulated/immintrin.h
$(emulated): CPPFLAGS += -DEMULATED -isystem tests/instructions/emulated
$(emulated): override CFLAGS += -Wno-psabi -fwrapv -fno-strict-aliasing \
	-fno-sanitize=undefined -march=$(plainest)
$(emulated): | $(BUILD)/setup/test

# The sanitizers are for what is tested, not for what is right. clang
# finds no lanes for the smallest of doubles.
$(BUILD)/plain/tests/oracle.o: override CFLAGS := -Wno-pass-failed $(filter-out \
	-O1 -fsanitize% -fno-sanitize% --coverage,$(CFLAGS))

tests_of = $(patsubst %.c,$(BUILD)/plain/%.o,tests/harness.c tests/oracle.c \
	$(wildcard tests/$(1)/*.c))
$(foreach f,$(test_folders),$(eval $(call link_rule,$(BUILD)/tests/$(f),$(call tests_of,$(f)),-lcunit)))

# What no other build of the programs changes.
no_program    := exercises export grade manual press release sheet

# The press runs what the book shows; the other tests want near at most.
tried := $(if $(filter exercises grade manual press sheet,$(TESTS)),$(programs),$(BUILD)/near $(BUILD)/range $(BUILD)/contact)

#: every test: programs, command line, press, exercises
test: $(tried) $(filter $(TESTS:%=$(BUILD)/tests/%),$(test_programs)) \
		| $(BUILD)/setup/test
	@BUILD=$(BUILD) CC="$(CC)" tests/run $(TESTS)

#: the tests with gcc and clang, and on the plainest processor, as CI
test-all: | $(BUILD)/setup/check
	$(MAKE) test CC=gcc BUILD=$(BUILD)/gcc WERROR=-Werror
	$(MAKE) test CC=clang BUILD=$(BUILD)/clang WERROR=-Werror
	$(MAKE) test CC=gcc BUILD=$(BUILD)/portable WERROR=-Werror MARCH=$(plainest)

# ---- the book ------------------------------------------------------
figures := $(patsubst book/figures/%.gp,$(BUILD)/figures/%.pdf,\
	$(filter-out book/figures/style.gp,$(wildcard book/figures/*.gp)))
# One run of LaTeX draws all that a chapter has, each on a page.
drawing_names := $(patsubst book/drawings/%.tex,%,\
	$(filter-out book/drawings/style.tex,$(wildcard book/drawings/*.tex)))
drawn_in       = $(BUILD)/drawings/$(firstword $(subst -, ,$(1))).pdf
drawings      := $(sort $(foreach d,$(drawing_names),$(call drawn_in,$(d))))
press   := CHANGES.md $(shell find book/press book/*.md book/*.bib -type f) \
	$(wildcard exercises/ch*/*/exercise.md)

# A figure is drawn from the tables that its file names.
tables := $(shell grep -o '/[a-z0-9-]*\.tsv' book/figures/*.gp)
$(foreach t,$(tables),$(eval $(patsubst book/figures/%.gp,$(BUILD)/figures/%.pdf,$(firstword \
	$(subst :, ,$(t)))): book/data$(lastword $(subst :, ,$(t)))))

$(BUILD)/figures/%.pdf: book/figures/%.gp book/figures/style.gp | $(BUILD)/setup/book
	@mkdir -p $(@D)
	$(call say,draw)
	$(Q)gnuplot -e "format = 'pdf'; output = '$@'; data = 'book/data'" $<

draw := book/drawings/style.tex book/drawings/draw
$(BUILD)/drawings/%.pdf: book/drawings/%.tex $(draw) | $(BUILD)/setup/book
	@mkdir -p $(@D)
	$(call say,draw)
	$(Q)book/drawings/draw $@ $<

define drawings_rule
$(1): $(wildcard book/drawings/$(basename $(notdir $(1)))-*.tex) $(draw) | $(BUILD)/setup/book
	@mkdir -p $$(@D)
	$$(call say,draw)
	$$(Q)book/drawings/draw $$@ $$(filter-out $(draw),$$^)
endef
$(foreach d,$(drawings),$(eval $(call drawings_rule,$(d))))

$(BUILD)/near-and-far.pdf: $(programs) $(figures) $(drawings) $(press) $(sources) \
		$(wildcard chapters/*.md code/*.h code/*/*.h code/*/*/*.h code/*/*.cc book/data/*.tsv) \
		| $(BUILD)/setup/book
	$(call say,print)
	$(Q)BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --build $(BUILD)

#: the book's faults, without typesetting it
check-book: $(programs) $(figures) $(drawings) | $(BUILD)/setup/test
	@BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --check --build $(BUILD)

#: every figure, as PDF under build/figures
figures: $(figures)

#: every drawing, a PDF for each chapter, and as SVG under build/drawings
drawings: $(drawings) $(drawing_names:%=$(BUILD)/drawings/%.svg)

# A drawing is a page of its chapter's PDF, -f 3 -l 3; a plot is alone.
on_page  = $(if $(wildcard book/drawings/$(1).tex),$$(awk '$$1 == "$(1)" \
	{ print "-f", $$2, "-l", $$2 }' $(<:.pdf=.pages)))
pictures := $(figures:$(BUILD)/%.pdf=$(BUILD)/pictures/%) \
	$(drawing_names:%=$(BUILD)/pictures/drawings/%)
$(foreach d,$(drawing_names),$(eval $(BUILD)/drawings/$(d).svg $(BUILD)/pictures/drawings/$(d).svg \
	$(BUILD)/pictures/drawings/$(d).png: $(call drawn_in,$(d))))
$(foreach f,$(figures),$(eval $(f:$(BUILD)/%.pdf=$(BUILD)/pictures/%.svg) \
	$(f:$(BUILD)/%.pdf=$(BUILD)/pictures/%.png): $(f)))

$(pictures:%=%.svg) $(drawing_names:%=$(BUILD)/drawings/%.svg): %.svg:
	@mkdir -p $(@D)
	$(call say,draw)
	$(Q)pdftocairo -svg $(call on_page,$(notdir $*)) $< $@
$(pictures:%=%.png): %.png:
	@mkdir -p $(@D)
	$(call say,draw)
	$(Q)pdftocairo -png -r 300 -singlefile $(call on_page,$(notdir $*)) $< $*

#: drawings and plots as SVG and PNG, under build/pictures
pictures: $(pictures:%=%.svg) $(pictures:%=%.png)

# ---- the web edition -----------------------------------------------
$(BUILD)/fonts/done: book/web/fonts | $(BUILD)/setup/web
	@mkdir -p $(@D)
	$(Q)book/web/fonts $(@D) && touch $@

# The modules once more, for browsers: one thread, no instruction sets.
# The page hands over texts in place of files.
wasm := $(filter-out code/common/stream.c code/common/report.c code/common/experiment.c,\
	$(foreach m,$(modules),$(if $(findstring avx,$(m)),,$(m)))) $(wildcard code/web/*.c)
$(BUILD)/near.wasm: $(wasm) $(wildcard code/*.h code/*/*.h code/web/sys/*.h) | $(BUILD)/setup/web
	$(call say,compile)
	$(Q)clang --target=wasm32-wasi -mexec-model=reactor -std=c17 -O3 -msimd128 \
		-ffp-contract=off -D_GNU_SOURCE -Icode -Icode/web -Wall -Wextra \
		-Wno-unknown-pragmas -Wno-unused-parameter -Wno-unused-variable \
		-Wno-missing-field-initializers $(WERROR) $(wasm) -o $@ \
		-lm -Wl,--gc-sections -Wl,--strip-all

# As text in a script: so a page that is a file can load it.
$(BUILD)/near.js: $(BUILD)/near.wasm
	@{ printf 'live.module = "'; base64 <$< | tr -d '\n'; echo '";'; } >$@

$(BUILD)/web/index.html: $(programs) $(pictures:%=%.svg) $(BUILD)/fonts/done $(press) \
		$(sources) $(wildcard chapters/*.md code/*.h code/*/*.h code/*/*/*.h \
		code/*/*.cc book/data/*.tsv book/web/* book/web/live/*) $(BUILD)/near.js \
		| $(BUILD)/setup/web
	$(call say,print)
	@rm -rf $(@D) && mkdir -p $(@D)/fonts $(@D)/pictures $(@D)/live
	$(Q)BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --web $(@D) --build $(BUILD)
	@cp book/web/*.css book/web/*.js $(@D)
	@cp book/web/live/*.js $(BUILD)/near.js $(@D)/live
	@cp $(BUILD)/fonts/*.woff2 $(@D)/fonts
	@cp $(pictures:%=%.svg) $(@D)/pictures

#: the web edition, under build/web: open index.html there
web: $(BUILD)/web/index.html

#: the web edition's links, numbers, HTML, and looks in a browser
check-web: $(BUILD)/web/index.html | $(BUILD)/setup/check-web
	@mkdir -p $(BUILD)/web-check && cp tests/web/package.json $(BUILD)/web-check
	@npm install --silent --no-audit --no-fund --prefix $(BUILD)/web-check
	@BUILD=$(BUILD) CC="$(CC)" tests/run browser web

# ---- slides --------------------------------------------------------
#: the slides of chapter N: build/slides/chNN.pdf
slidesN:
	@echo "say make slides1, make slides2, ..., or make slides for all"

# Plots are drawn anew for slides, with larger letters.
$(BUILD)/slides/figures/%.pdf: book/figures/%.gp book/figures/style.gp | $(BUILD)/setup/book
	@mkdir -p $(@D)
	$(call say,draw)
	$(Q)gnuplot -e "format = 'slide'; output = '$@'; data = 'book/data'" $<

# Slides wait for the pictures that they name.
slides      := $(patsubst chapters/slides/%.md,%,$(wildcard chapters/slides/ch*.md))
shown       := $(shell grep -o ']([a-z0-9-]*)' $(slides:%=chapters/slides/%.md) /dev/null | tr -d '()]')
shown_in     = $(patsubst chapters/slides/$(1).md:%,%,$(filter chapters/slides/$(1).md:%,$(shown)))
picture_of   = $(if $(wildcard book/drawings/$(1).tex),$(call drawn_in,$(1)),$(BUILD)/slides/figures/$(1).pdf)
define slides_rule
.PHONY: slides$(call number_of,$(1:ch%=%))
slides$(call number_of,$(1:ch%=%)): $(BUILD)/slides/$(1).pdf
$(BUILD)/slides/$(1).pdf: chapters/slides/$(1).md $(wildcard chapters/$(1)-*.md) \
		$(foreach p,$(call shown_in,$(1)),$(call picture_of,$(p))) \
		$(press) $(sources) $(wildcard book/data/*.tsv) | $(BUILD)/setup/book
	$$(call say,print)
	$$(Q)BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --slides $$< --build $(BUILD)
endef
number_of = $(shell expr $(1) + 0)
$(foreach s,$(slides),$(eval $(call slides_rule,$(s))))

#: the slides of all chapters
slides: $(slides:%=$(BUILD)/slides/%.pdf)

#: the pictures and the numbers in README.md, from book/data
readme: | $(BUILD)/setup/book
	gnuplot -e "format = 'png'; output = 'book/nearest-and-furthest.png'; \
		data = 'book/data'" book/figures/ch01-arrows.gp
	gnuplot -e "format = 'png'; output = 'book/journey.png'; \
		data = 'book/data'" book/figures/ch10-journey.gp
	$(LUA) book/press/readme.lua README.md book/data/ch10-journey.tsv

# ---- chapters and measurements -------------------------------------
#: test and demonstrate chapter N
chapterN:
	@echo "say make chapter1, make chapter2, ..."

define chapter_rule
.PHONY: chapter$(1) measure$(1)
chapter$(1): $(BUILD)/near $(filter $(BUILD)/ch$(2)/%,$(programs)) \
		$(filter $(BUILD)/tests/ch$(2)%,$(test_programs)) | $(BUILD)/setup/code
	@BUILD=$(BUILD) CC="$(CC)" book/experiments/demonstrate $(1)

measure$(1): $(programs)
	@BUILD=$(BUILD) CC="$(CC)" book/experiments/measure ch$(2)
endef
$(foreach c,$(chapters),$(eval $(call chapter_rule,$(call \
	number_of,$(firstword $(subst -, ,$(c)))),$(firstword $(subst -, ,$(c))))))

#: measure everything anew, in about 20 minutes
measure: $(programs)
	@BUILD=$(BUILD) CC="$(CC)" book/experiments/measure ch

#: measure chapter N anew
measureN:
	@echo "say make measure1, make measure2, ..."

# What valgrind and llvm-mca count of the chapters named.
define count
	@for script in $(wildcard $(1:%=book/experiments/ch%-evidence.sh)); do \
	    name=$$(basename "$$script" .sh); echo "count $$name"; \
	    BUILD=$(BUILD) CC="$(CC)" sh "$$script" \
	        >"$(BUILD)/$$name.tsv" && \
	    mv "$(BUILD)/$$name.tsv" book/data || exit 1; \
	done
endef

#: count anew what valgrind and llvm-mca count, in a minute
evidence: $(programs) | $(BUILD)/setup/evidence
	$(call count,*)

#: count anew for chapter N
evidenceN:
	@echo "say make $(foreach c,$(counted),evidence$(call number_of,$(c)))"

counted := $(patsubst book/experiments/ch%-evidence.sh,%,$(wildcard book/experiments/*-evidence.sh))
define evidence_rule
.PHONY: evidence$(1)
evidence$(1): $(programs) | $(BUILD)/setup/evidence
	$$(call count,$(2))
endef
$(foreach c,$(counted),$(eval $(call evidence_rule,$(call number_of,$(c)),$(c))))

# ---- other libraries -----------------------------------------------
# What only `make peers` needs: C++, and the libraries themselves.
peers     := $(patsubst code/%.cc,$(BUILD)/plain/%.o,$(wildcard code/peers/*.cc))
PEERFLAGS := -std=c++17 -O3 -march=$(MARCH) -fopenmp
PEERLIBS  := -lann -ltbb -llz4 -lBulletCollision -lLinearMath

$(peers): $(BUILD)/plain/peers/%.o: code/peers/%.cc $(BUILD)/flags \
		| $(BUILD)/setup/peers
	@mkdir -p $(@D)
	$(call say,compile)
	$(Q)$(CXX) $(CPPFLAGS) -DCGAL_LINKED_WITH_TBB \
		-isystem /usr/include/bullet $(PEERFLAGS) -Wall -Wextra \
		$(WERROR) -c $< -o $@

$(BUILD)/plain/peers/contenders.o: CPPFLAGS += -DPEER_FLAGS='"$(PEERFLAGS)"'

contests := $(addprefix $(BUILD)/peers/,compare crowds ranges contacts)
$(contests): $(BUILD)/peers/%: $(BUILD)/plain/peers/%.o $(libraries) \
		$(peers)
	@mkdir -p $(@D)
	$(call say,link)
	$(Q)$(CXX) $(PEERFLAGS) $< $(libraries) $(peers) $(libraries) -o $@ \
		$(PEERLIBS) $(LDLIBS)

#: measure other libraries beside the book (QUICK=yes: a glimpse; FILES=...)
peers: $(contests)
	@BUILD=$(BUILD) QUICK=$(QUICK) book/experiments/peers $(FILES)

# ---- exercises -----------------------------------------------------
# exercises/ch02/1-nearest-pair is exercise 2.1. An answer that is wrong
# is no mistake of make's.
exercise_key = $(patsubst 0%,%,$(firstword $(subst /, ,$(1)))).$(firstword \
	$(subst -, ,$(word 2,$(subst /, ,$(1)))))
exercises := $(foreach e,$(patsubst exercises/ch%/exercise.md,%,$(wildcard \
	exercises/ch*/*/exercise.md)),exercise$(call exercise_key,$(e)))

#: all exercises, a line each: stars, time, points, how they are marked
exercises:
	@exercises/kit/list

#: try exercise K of chapter N: task and starter in work/, tests, points
exerciseN.K:
	@echo "say make exercise1.2, make exercise2.1, ..."

$(exercises): exercise%: | $(BUILD)/setup/code
	@BUILD=$(BUILD) CC="$(CC)" MARCH=$(MARCH) exercises/kit/exercise $* || [ $$? -eq 1 ]

watches := $(exercises:exercise%=watch%)

#: the same at each save, and when it passes the next exercise
watchN.K:
	@echo "say make watch2.1, ..."

$(watches): watch%: | $(BUILD)/setup/code
	@BUILD=$(BUILD) CC="$(CC)" MARCH=$(MARCH) exercises/kit/watch $*

hints := $(exercises:exercise%=hint%)

#: the next hint for exercise K of chapter N
hintN.K:
	@echo "say make hint1.2, make hint2.1, ..."

$(hints): hint%:
	@BUILD=$(BUILD) exercises/kit/hint $*

#: grade a student's folder, WORK=work, or a class of them, CLASS=folder
grade: | $(BUILD)/setup/code
	@BUILD=$(BUILD) CC="$(CC)" MARCH=$(MARCH) exercises/kit/grade

include $(wildcard exercises/course/course.mk)

# ---- checks --------------------------------------------------------
#: data races: the planted one is found, and no other
check-race: | $(BUILD)/setup/check
	tests/check-race $(BUILD)/race

#: mistakes planted in the modules: the tests notice each
check-mutations: | $(BUILD)/setup/test
	tests/check-mutations $(BUILD)

#: the programs' tests under sanitizers, and what they cover
check-memory: | $(BUILD)/setup/test
	@rm -rf $(BUILD)/memory/plain/*/*.gcda $(BUILD)/memory/plain/*/*/*.gcda
	ASAN_OPTIONS=allocator_may_return_null=1 $(MAKE) test BUILD=$(BUILD)/memory \
		TESTS="$(filter-out $(no_program),$(TESTS))" \
		CFLAGS="-O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all \
		-fsanitize=address,undefined,float-cast-overflow --coverage -fprofile-update=single"
	tests/coverage $(BUILD)/memory 93

# OpenMP's pragmas make the analyzer see values that nothing has set, so
# it reads the programs as one thread would run them.
analyzed := $(patsubst code/%.c,$(BUILD)/analyzed/%.o,\
	$(modules) $(wildcard code/near/*.c code/range/*.c code/contact/*.c))

#: gcc's static analyzer on every module
analyze: $(analyzed)

$(BUILD)/analyzed/%.o: code/%.c $(BUILD)/flags | $(BUILD)/setup/code
	@mkdir -p $(@D)
	$(call say,analyze)
	$(Q)gcc $(CPPFLAGS) -std=c17 -O1 -march=$(MARCH) -ffp-contract=off \
		-fanalyzer -Wno-analyzer-use-of-uninitialized-value -Werror -c $< -o $@

FOR ?= 600
#: bytes that the readers of points and meshes do not expect, FOR=600 seconds each
fuzz: | $(BUILD)/setup/check
	tests/check-fuzz $(BUILD)/fuzz $(FOR)

#: corpus and command line on an emulated arm64 processor
check-arm64: | $(BUILD)/setup/arm64
	tests/check-arm64 $(BUILD)/arm64

#: lay out the C as .clang-format says
format: | $(BUILD)/setup/check
	clang-format -i $$(git ls-files '*.c' '*.h' '*.cc')

#: remove everything generated
clean:
	rm -rf $(BUILD)

.DEFAULT:
	@echo "nothing makes $@; make help lists what there is" >&2; exit 2

#: this list
help:
	@awk '/^#: / { text = substr($$0, 4); next } \
	  text != "" { split($$0, a, ":"); printf "  %-15s %s\n", a[1], text; text = "" }' \
	  Makefile $(wildcard exercises/course/course.mk)

# What each object and each program waits for, of those that there are.
compiled := $(sources:code/%=%) $(patsubst code/%,%,$(wildcard code/peers/*.cc)) \
	$(wildcard tests/*.c tests/*/*.c)
-include $(wildcard $(patsubst %,$(BUILD)/plain/%.d,$(basename $(compiled))) \
	$(patsubst %,%.d,$(programs) $(test_programs)))

.PHONY: all programs test test-all check-book figures drawings pictures web check-web slides slidesN readme chapterN measure measureN evidence evidenceN
.PHONY: exercises $(exercises) exerciseN.K $(watches) watchN.K $(hints) hintN.K grade peers check-race check-mutations check-memory analyze fuzz check-arm64 format clean help
