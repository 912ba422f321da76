// Options by getopt_long, with sentences of our own.
#include "near/command.h"
#include "common/fail.h"

static _Noreturn void refuse(const char *program, int why, char **argv)
{
    const char *word = argv[optind - 1];
    if (why == ':')
        fail("%s needs a value; see %s --help", word, program);
    if (optopt > ' ' && optopt < 256) // a letter
        fail("what is -%c? See %s --help", optopt, program);
    fail("what is %s? See %s --help", word, program);
}

const char *take_options(const struct command *command, int argc,
                         char **argv, void *options)
{
    opterr = 0; // no sentences of getopt's
    for (int option;
         (option = getopt_long(argc, argv, command->letters,
                               command->names, NULL)) != -1;)
        if (option == ':' || option == '?')
            refuse(command->program, option, argv);
        else if (option != 0) // a flag has been set
            command->take(options, option);
    if (argc - optind > 1)
        fail("one FILE at a time, please: \"%s\" and \"%s\" are two",
             argv[optind], argv[optind + 1]);
    return argv[optind];
}
