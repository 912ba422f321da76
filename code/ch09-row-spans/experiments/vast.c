// Row spans on all processors, once: how long it takes for a point, and
// how many bytes a point the program had in memory at most, its points
// and answers included.
//     vast [POINTS]
#include "common/experiment.h"
#include <sys/resource.h>

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 3000000, 2, MANY / 2);
    struct question question = uniform_question(STANDARD, n, 1);
    question.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, NEAREST);
    int64_t start = clock_ns();
    find_algorithm("row-spans")->run(&question, answers);
    double ns = (double)(clock_ns() - start) / n;
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage); // in units of 1024 bytes
    print_header(&e, "name n threads ns bytes");
    row("points\t%u\t%d\t%.4g\t%.4g", n, question.threads, ns,
        1024.0 * usage.ru_maxrss / n);
}
