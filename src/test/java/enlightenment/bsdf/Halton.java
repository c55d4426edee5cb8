package enlightenment.bsdf;

/** Numbers in 0..1 that are spread more evenly than random ones. */
final class Halton {
    private Halton() {}

    /** A number of the sequence of a base: van der Corput's. */
    static double at(int base, int k) {
        double sum = 0;
        double digit = 1;
        for (int rest = k; rest > 0; rest /= base) {
            digit /= base;
            sum += digit * (rest % base);
        }
        return sum;
    }
}
