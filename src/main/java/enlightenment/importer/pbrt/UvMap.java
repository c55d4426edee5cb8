package enlightenment.importer.pbrt;

/** The map of texture coordinates (u, v) → (su·u + du, sv·v + dv). */
record UvMap(double su, double sv, double du, double dv) {
    static final UvMap IDENTITY = new UvMap(1, 1, 0, 0);

    double u(double u) {
        return su * u + du;
    }

    double v(double v) {
        return sv * v + dv;
    }
}
