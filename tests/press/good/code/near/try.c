int tries = 3;
//> Try it
int main(void) { return 0; }
//<
