package enlightenment.emitter;

import enlightenment.numeric.Arcs;

/**
 * Irradiance of a rectangle of radiance 1 above a receiver's horizon: Lambert's sum over the edges, as in {@link HorizonPolygon}, in
 * coordinates parallel to them. There the cross products of an edge's corners have no differences that cancel, and θ/sin θ of the angle
 * that an edge covers is computed from its cosine ({@link Arcs#overSine}), so that one division serves all edges.
 */
final class LambertRectangle {
    private LambertRectangle() {}

    /**
     * The irradiance for radiance 1.
     *
     * @param x the rectangle's least coordinate along its first edge, from the receiver
     * @param width the length of that edge
     * @param y the least coordinate along its second edge, whose length is {@code length}
     * @param z the coordinate of its plane
     * @param nx the receiver's unit normal in these coordinates
     * @return NaN if the horizon cuts the rectangle, or an edge covers more than 120°: the caller must use another form
     */
    static double irradiance(
            double x, double width, double y, double length, double z, double nx, double ny, double nz) {
        double right = x + width;
        double high = y + length;
        if (!(Math.min(nx * x, nx * right) + Math.min(ny * y, ny * high) + nz * z >= 0)) {
            return Double.NaN;
        }
        double zz = z * z;
        double low2 = Math.fma(y, y, zz);
        double high2 = Math.fma(high, high, zz);
        double xx = x * x;
        double rr = right * right;
        double a = Math.sqrt(xx + low2);
        double b = Math.sqrt(rr + low2);
        double c = Math.sqrt(rr + high2);
        double d = Math.sqrt(xx + high2);
        double ab = a * b;
        double cd = c * d;
        double inverse = 1 / (ab * cd);
        double overAb = cd * inverse;
        double overCd = ab * inverse;
        double overBc = a * d * inverse;
        double overDa = b * c * inverse;
        double across = x * right;
        double up = Math.fma(y, high, zz);
        double cosAb = (across + low2) * overAb;
        double cosCd = (across + high2) * overCd;
        double cosBc = (rr + up) * overBc;
        double cosDa = (xx + up) * overDa;
        if (!(Math.min(Math.min(cosAb, cosCd), Math.min(cosBc, cosDa)) >= Arcs.LEAST_COSINE)) {
            return Double.NaN;
        }
        double alongFirst = Math.fma(ny, z, -nz * y) * overAb * Arcs.overSine(cosAb)
                - Math.fma(ny, z, -nz * high) * overCd * Arcs.overSine(cosCd);
        double alongSecond = Math.fma(nx, z, -nz * x) * overDa * Arcs.overSine(cosDa)
                - Math.fma(nx, z, -nz * right) * overBc * Arcs.overSine(cosBc);
        return Math.min(0.5 * Math.abs(Math.fma(width, alongFirst, length * alongSecond)), Math.PI);
    }
}
