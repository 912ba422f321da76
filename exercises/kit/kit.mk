# Builds what exercises/kit/exercise and exercises/kit/check ask for:
# the graders, in three variants, and the student's file as a library.
# BUILD and CC come from the environment.
K     := $(BUILD)/kit
MARCH ?= native
.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:

flags := -std=c17 -g -fPIC -fopenmp -ffp-contract=off -D_GNU_SOURCE \
	-Wall -Wextra -Wpedantic -Icode -Iexercises/kit
sanitized := $(flags) -O1 -fno-omit-frame-pointer \
	-fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all
optimized := $(flags) -O3 -march=$(MARCH)
quick     := $(flags) -O1
# As different as can be: the other compiler, if it has OpenMP, and the
# plainest processor.
plain      = $(flags) -O3 -march=$(if $(filter x86_64,$(shell uname -m)),x86-64,native)
other     := $(if $(findstring clang,$(CC)),gcc,clang)
# Tried once, by the first make that wants to know.
export RIVAL
rival      = $(eval RIVAL := $(or $(RIVAL),$(if $(shell echo 'int main(void) { return 0; }' | \
	$(other) -fopenmp -x c - -o /dev/null 2>&1),$(CC),$(other))))$(RIVAL)
compiler   = $(if $(filter plain,$(1)),$(rival),$(CC))
# With hooks for slow_motion.h, if the tests want them.
# With the machine's lanes, if the tests ask for them: the sanitizers
# shall see them, too.
lanes = $(if $(shell grep -l __AVX2__ exercises/$(1)/tests.c),-march=$(MARCH))
slow = $(if $(shell grep -l slow_motion.h exercises/$(1)/tests.c),-fsanitize=thread)

exercises  := $(patsubst exercises/%/exercise.md,%,$(wildcard exercises/*/*/exercise.md))
programmed := $(patsubst exercises/%/tests.c,%,$(wildcard exercises/*/*/tests.c))
naive      := $(patsubst exercises/%/naive.c,%,$(wildcard exercises/*/*/naive.c))
# What the kit and the tests need of the book's modules.
modules    := $(addprefix common/,allocate clock fail generate generate_crowds points random)
kit_modules := kit judge confine fence marks threads slow_motion
headers    := $(wildcard code/common/*.h exercises/kit/*.h)

# ---- graders -------------------------------------------------------
define variant_rules
$(K)/$(1)/common/%.o: code/common/%.c $(headers)
	@mkdir -p $$(@D)
	$$(call compiler,$(1)) $$($(1)) -c $$< -o $$@

$(K)/$(1)/%.o: exercises/kit/%.c $(headers)
	@mkdir -p $$(@D)
	$$(call compiler,$(1)) $$($(1)) -c $$< -o $$@

$(K)/$(1)/%/grader: exercises/%/tests.c exercises/%/exercise.h \
		$(kit_modules:%=$(K)/$(1)/%.o) $(modules:%=$(K)/$(1)/%.o)
	@mkdir -p $$(@D)
	$$(call compiler,$(1)) $$($(1)) -Werror -rdynamic -Iexercises/$$* \
		$$(filter %.c %.o,$$^) -o $$@ -lm -ldl
endef
$(foreach v,sanitized optimized plain,$(eval $(call variant_rules,$(v))))

# ---- the student's file: SOURCE, as a library TO -------------------
# The shell expands both names, for they may be anything. TO.d lists
# all that was included. SEAL is nothing, or runs the compiler behind a
# fence, in a folder with the headers that there are here. It is linked
# apart, for the hooks' own library shall not come with them.
export SOURCE TO
library:
	$(SEAL) $(call compiler,$(VARIANT)) $($(VARIANT)) $(STRICT) -Wno-unused-parameter -Iexercises/$(EXERCISE) \
		$(if $(filter-out sanitized,$(VARIANT)),$(call slow,$(EXERCISE))) \
		$(if $(filter sanitized,$(VARIANT)),$(call lanes,$(EXERCISE))) \
		-MD -MF "$$TO.d" -c "$$SOURCE" -o "$$TO.o"
	$(SEAL) $(call compiler,$(VARIANT)) $($(VARIANT)) -shared -Wl,-Bsymbolic "$$TO.o" -o "$$TO" -lm

# What compiles behind a fence.
$(K)/seal: $(addprefix exercises/kit/,seal.c confine.c fence.c) \
		code/common/clock.c code/common/fail.c code/common/allocate.c $(headers)
	@mkdir -p $(@D)
	$(CC) $(optimized) $(filter %.c,$^) -o $@ -lm

# ---- the reports ---------------------------------------------------
$(K)/results: exercises/kit/results.c
	@mkdir -p $(@D)
	$(CC) $(optimized) $< -o $@

$(K)/%/starter.c: exercises/%/solution.c exercises/%/exercise.md \
		exercises/kit/starter.awk
	@mkdir -p $(@D)
	awk -f exercises/kit/starter.awk $< >$@

# ---- the check: each result is a line that says ok or not ok -------
mutants := $(foreach e,$(programmed),$(patsubst exercises/%.sed,$(K)/%.result,\
	$(wildcard exercises/$(e)/mutants/*.sed)))
results := $(exercises:%=$(K)/%/text.result) \
	$(programmed:%=$(K)/%/starter.result) \
	$(programmed:%=$(K)/%/solution.result) \
	$(programmed:%=$(K)/%/rival.result) $(naive:%=$(K)/%/naive.result) \
	$(mutants)

check: $(results)
	@cat $(results)

kit := $(addprefix exercises/kit/,check common.sh kit.mk starter.awk)
$(K)/%/text.result: exercises/%/exercise.md $(kit)
	@mkdir -p $(@D)
	exercises/kit/check text $* >$@

define result_rules
$(K)/$(1)/starter.result: $(K)/$(1)/starter.c $(K)/optimized/$(1)/grader $(kit)
	exercises/kit/check starter $(1) >$$@

$(K)/$(1)/solution.result: exercises/$(1)/solution.c $(kit) \
		$(K)/optimized/$(1)/grader $(K)/sanitized/$(1)/grader
	exercises/kit/check solution $(1) >$$@

$(K)/$(1)/rival.result: exercises/$(1)/solution.c $(kit) \
		$(K)/plain/$(1)/grader
	exercises/kit/check rival $(1) >$$@

$(K)/$(1)/naive.result: exercises/$(1)/naive.c $(kit) \
		$(K)/optimized/$(1)/grader
	@mkdir -p $$(@D)
	exercises/kit/check naive $(1) >$$@

$(K)/$(1)/mutants/%.result: exercises/$(1)/mutants/%.sed $(kit) \
		exercises/$(1)/solution.c $(K)/optimized/$(1)/grader
	@mkdir -p $$(@D)
	exercises/kit/check mutant $(1) $$* >$$@
endef
$(foreach e,$(programmed),$(eval $(call result_rules,$(e))))

.PHONY: library check
