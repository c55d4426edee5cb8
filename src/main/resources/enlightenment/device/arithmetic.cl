// Whether this device computes as Java does: device.Arithmetic compares.

__kernel void arithmetic(__global const double *in, __global double *out, int count) {
    int k = (int) get_global_id(0);
    if (k >= count) {
        return;
    }
    double a = in[3 * k];
    double b = in[3 * k + 1];
    double c = in[3 * k + 2];
    __global double *o = out + ARITHMETIC_RESULTS * k;
    o[0] = a + b;
    o[1] = a - b;
    o[2] = a * b;
    o[3] = a / b;
    o[4] = sqrt(fabs(a));
    o[5] = fma(a, b, c);
    o[6] = a * b + c;
    o[7] = floor(a);
    o[8] = sobolX((uint) k, hashOf((ulong) k, 7));
    o[9] = angleOf(a, b);
}

// Fused operations one after the other, four at a time: how fast the device is.
__kernel void chain(__global double *out, int steps) {
    int k = (int) get_global_id(0);
    double a = k;
    double b = a + 1;
    double c = a + 2;
    double d = a + 3;
    for (int i = 0; i < steps; i++) {
        a = fma(a, 0.5, 1.0);
        b = fma(b, 0.5, 1.0);
        c = fma(c, 0.5, 1.0);
        d = fma(d, 0.5, 1.0);
    }
    out[k] = a + b + c + d;
}
