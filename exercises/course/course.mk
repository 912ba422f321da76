# What only instructors need; not in the handout.

#: all exercises, a line each, to choose from
exercises:
	@exercises/course/list

#: an assignment with its archives: EXERCISES="4.1 4.2" TITLE="Homework 2"
sheet: | $(BUILD)/setup/book
	@BUILD=$(BUILD) exercises/course/sheet

#: the book for students, without solutions
handout: $(BUILD)/near-and-far.pdf | $(BUILD)/setup/book
	@BUILD=$(BUILD) exercises/course/handout

$(BUILD)/solutions.pdf: $(press) $(wildcard chapters/ch*.md book/data/*.tsv) \
		| $(BUILD)/setup/book
	$(call say,print)
	$(Q)BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --solutions --build $(BUILD)

#: the instructor's manual: solutions, mistakes, marking, course plans
solutions: $(BUILD)/solutions.pdf

.PHONY: exercises sheet handout solutions
