# What only instructors need; not in the handout.

#: an assignment with its archives: EXERCISES="4.1 4.2" TITLE="Homework 2"
sheet: | $(BUILD)/setup/book
	@BUILD=$(BUILD) exercises/course/sheet

#: the book for students, without solutions; a release has it ready
handout: | $(BUILD)/setup/book
	@echo "What this makes is the student's edition, which every release has ready:"
	@echo "near-and-far-VERSION.tar.gz. If you have changed nothing, hand that out."
	@echo "Anew it takes ten minutes or so, most of them for the book. Ctrl-C ends it."
	@rm -rf $(BUILD)/handout
	@$(MAKE) --no-print-directory $(BUILD)/near-and-far.pdf
	@BUILD=$(BUILD) exercises/course/handout

$(BUILD)/solutions.pdf: $(press) $(wildcard chapters/ch*.md book/data/*.tsv) \
		$(shell find book/manual exercises/ch* -type f) | $(BUILD)/setup/book
	@echo "print $@, in about a minute"
	$(Q)BUILD=$(BUILD) CC="$(CC)" $(LUA) book/press/press.lua --solutions --build $(BUILD)

#: the instructor's manual: solutions, mistakes, marking, course plans
solutions: $(BUILD)/solutions.pdf

#: exam questions and exercises for Canvas and Moodle: build/export/
export: | $(BUILD)/setup/test
	@BUILD=$(BUILD) exercises/course/export

#: both editions, the PDF, pictures, web pages, checksums: VERSION=2.0
release: | $(BUILD)/setup/book
	@BUILD=$(BUILD) VERSION="$(VERSION)" exercises/course/release --check
	@$(MAKE) --no-print-directory $(BUILD)/near-and-far.pdf \
	    $(BUILD)/solutions.pdf slides pictures export web
	@BUILD=$(BUILD) VERSION="$(VERSION)" exercises/course/release

#: unpacks a release and tries all of it, in half an hour
check-release: | $(BUILD)/setup/book
	@BUILD=$(BUILD) CC="$(CC)" tests/check-release $(BUILD)/release

.PHONY: sheet handout solutions export release check-release
