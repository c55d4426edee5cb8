module both {
    requires enlightenment;
    requires tools.jackson.core;
}
