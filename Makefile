# Near and Far: the one entry point. `make help` lists every target.
#
#   MARCH=native   the processor to build for (x86-64 for any PC)
#   BUILD=build    where everything generated goes
#   WERROR=-Werror warnings stop the build, as they do in CI

MARCH  ?= native
BUILD  ?= build
WERROR ?=
LUA    := texlua

override CFLAGS := -std=c17 -O3 -march=$(MARCH) -ffp-contract=off \
	-fopenmp -Wall -Wextra -Wpedantic $(WERROR) $(CFLAGS)
CPPFLAGS := -Icode -D_GNU_SOURCE -MMD -MP
LDLIBS   := -lm

# ---- what there is -------------------------------------------------
chapters  := $(patsubst code/ch%,%,$(wildcard code/ch*))
sources   := $(wildcard code/*.c code/ch*/*.c code/common/*.c)
modules   := $(foreach c,$(sources),$(if $(wildcard $(c:.c=.h)),$(c)))
mains     := $(filter-out $(modules) code/near.c,$(sources))
chapter_of = ch$(firstword $(subst -, ,$(patsubst code/ch%,%,$(1))))
program_of = $(BUILD)/$(call chapter_of,$(1))/$(basename $(notdir $(1)))
programs  := $(BUILD)/near $(foreach c,$(mains),$(call program_of,$(c)))

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
	@./setup $*
	@mkdir -p $(@D) && touch $@

# ---- modules, twice: as they are, and counting ---------------------
objects  := $(modules:code/%.c=$(BUILD)/plain/%.o)
counting := $(modules:code/%.c=$(BUILD)/counting/%.o)

$(BUILD)/plain/%.o: code/%.c | $(BUILD)/setup/code
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -c $< -o $@

$(BUILD)/counting/%.o: code/%.c | $(BUILD)/setup/code
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) $(CFLAGS) -DCOUNTING -c $< -o $@

# A table of measurements says with which flags it was made.
$(BUILD)/plain/common/report.o: CPPFLAGS += -DBUILD_FLAGS='"$(CFLAGS)"'

# The counting twin keeps its own names to itself.
$(BUILD)/counting.o: $(counting)
	$(CC) -r -nostdlib -o $@.all $^
	objcopy --keep-global-symbol=counting_algorithms \
		--keep-global-symbol=counting_take $@.all $@
	@rm -f $@.all

$(BUILD)/near: $(BUILD)/plain/near.o $(objects) $(BUILD)/counting.o
	$(CC) $(CFLAGS) $^ -o $@ $(LDLIBS)

define program_rule
$(call program_of,$(1)): $(1:code/%.c=$(BUILD)/plain/%.o) $$(objects) \
		$(BUILD)/counting.o
	@mkdir -p $$(@D)
	$$(CC) $$(CFLAGS) $$^ -o $$@ $$(LDLIBS)
endef
$(foreach c,$(mains),$(eval $(call program_rule,$(c))))

# ---- tests ---------------------------------------------------------
test_folders  := $(sort $(notdir $(patsubst %/,%,$(dir $(wildcard tests/*/*.c)))))
test_programs := $(test_folders:%=$(BUILD)/tests/%)

$(BUILD)/plain/tests/%.o: tests/%.c | $(BUILD)/setup/test
	@mkdir -p $(@D)
	$(CC) $(CPPFLAGS) -Itests $(CFLAGS) -c $< -o $@

define test_rule
$(BUILD)/tests/$(1): $(patsubst %.c,$(BUILD)/plain/%.o,tests/harness.c \
		$(wildcard tests/$(1)/*.c)) $$(objects) $(BUILD)/counting.o
	@mkdir -p $$(@D)
	$$(CC) $$(CFLAGS) $$^ -o $$@ -lcunit $$(LDLIBS)
endef
$(foreach f,$(test_folders),$(eval $(call test_rule,$(f))))

#: every test: programs, command line, press, exercises
test: $(programs) $(test_programs) | $(BUILD)/setup/test
	@BUILD=$(BUILD) CC="$(CC)" tests/run $(notdir $(wildcard tests/*/.))

#: remove everything generated
clean:
	rm -rf $(BUILD)

#: this list
help:
	@awk '/^#: / { text = substr($$0, 4); next } \
	  text != "" { split($$0, a, ":"); printf "  %-14s %s\n", a[1], text; text = "" }' \
	  Makefile

-include $(patsubst %.o,%.d,$(objects) $(counting)) $(wildcard $(BUILD)/plain/*/*.d $(BUILD)/plain/*/*/*.d)

.PHONY: all programs test clean help
