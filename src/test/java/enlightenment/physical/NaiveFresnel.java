package enlightenment.physical;

/** The share of light that a smooth interface reflects, by Fresnel's equations as textbooks write them. */
final class NaiveFresnel {
    private NaiveFresnel() {}

    /** The cosine on the other side by Snell's law, NaN if the light is totally reflected. */
    static double refracted(double cosine, double from, double to) {
        double sine = from / to * Math.sqrt(1 - cosine * cosine);
        return sine > 1 ? Double.NaN : Math.sqrt(1 - sine * sine);
    }

    /** Perpendicular and parallel polarisation, each as a share of power. */
    static double[] polarized(double cosine, double from, double to) {
        double c = Math.min(1, Math.abs(cosine));
        double t = refracted(c, from, to);
        if (Double.isNaN(t)) {
            return new double[] {1, 1};
        }
        double rs = (from * c - to * t) / (from * c + to * t);
        double rp = (to * c - from * t) / (to * c + from * t);
        return new double[] {rs * rs, rp * rp};
    }

    /** Unpolarised light at the interface of two dielectrics. */
    static double dielectric(double cosine, double from, double to) {
        double[] r = polarized(cosine, from, to);
        return (r[0] + r[1]) / 2;
    }

    /** A pane with two parallel surfaces: R + T²R + T²R³ + … for each polarisation. */
    static double pane(double cosine, double from, double to) {
        double sum = 0;
        for (double r : polarized(cosine, from, to)) {
            double through = (1 - r) * (1 - r);
            double round = 1;
            double reflected = r;
            for (int k = 0; k < 2000 && r < 1; k++) {
                reflected += through * r * round;
                round *= r * r;
            }
            sum += reflected;
        }
        return sum / 2;
    }

    /** A metal of index eta + i·k in empty space, by complex numbers. */
    static double conductor(double cosine, double eta, double k) {
        double[] n = {eta, k};
        double[] sine = divide(new double[] {Math.sqrt(Math.max(0, 1 - cosine * cosine)), 0}, n);
        double[] square = times(sine, sine);
        double[] inner = root(new double[] {1 - square[0], -square[1]});
        double[] outer = {cosine, 0};
        double[] s = divide(minus(outer, times(n, inner)), plus(outer, times(n, inner)));
        double[] p = divide(minus(times(n, outer), inner), plus(times(n, outer), inner));
        return (s[0] * s[0] + s[1] * s[1] + p[0] * p[0] + p[1] * p[1]) / 2;
    }

    /** Schlick's approximation. */
    static double schlick(double cosine, double straight) {
        return straight + (1 - straight) * Math.pow(1 - cosine, 5);
    }

    private static double[] plus(double[] a, double[] b) {
        return new double[] {a[0] + b[0], a[1] + b[1]};
    }

    private static double[] minus(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1]};
    }

    private static double[] times(double[] a, double[] b) {
        return new double[] {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
    }

    private static double[] divide(double[] a, double[] b) {
        double d = b[0] * b[0] + b[1] * b[1];
        return new double[] {(a[0] * b[0] + a[1] * b[1]) / d, (a[1] * b[0] - a[0] * b[1]) / d};
    }

    private static double[] root(double[] a) {
        double r = Math.sqrt(Math.hypot(a[0], a[1]));
        double half = Math.atan2(a[1], a[0]) / 2;
        return new double[] {r * Math.cos(half), r * Math.sin(half)};
    }
}
