// Rectangles sampled evenly over their solid angle: emitter.SphericalRectangle and GrazingRectangle, which takes over where nearly all of
// one is seen along its plane.
#define LEAST_GRAZING_COSINE 0x1p-6
#define LEAST_SOLID_ANGLE 1e-3

typedef struct {
    double x0;
    double x1;
    // Mirrored where that is needed for y0 + y1 ≥ 0.
    double y0;
    double y1;
    double length;
    double height;
    double zz;
    double left;
    double right;
    double solidAngle;
    double before;
    double beyondLeft;
    double beyondRight;
    double e0;
    double e1;
    double strip;
    bool obtuseStrip;
    bool obtuseEdge;
} Grazing;

typedef struct {
    // The last point chosen.
    double x;
    double y;
    double solidAngle;
    double x0;
    double x1;
    double y0;
    double y1;
    double height;
    double width;
    double length;
    double zz;
    double low2;
    double high2;
    double left2;
    double right2;
    double b0;
    double a0;
    double b1;
    double startSine;
    double startCosine;
    bool isGrazing;
    Grazing grazing;
} Spherical;

// Twice the angle of the product of two complex numbers, of the triangles of a rectangle.
double angleOfTriangles(double numerator, double lower, double upper) {
    return 2 * angleOf(numerator * (lower + upper), lower * upper - numerator * numerator);
}

double quarterOfGrazing(const Grazing *g, double left, double right, double width, double low, double high, double length) {
    double low2 = low * low + g->zz;
    double high2 = high * high + g->zz;
    double l00 = sqrt(left * left + low2);
    double l10 = sqrt(right * right + low2);
    double l11 = sqrt(right * right + high2);
    double l01 = sqrt(left * left + high2);
    double across = left * right + low * high + g->zz;
    double diagonal = l00 * l11;
    double lower = (left * right + low2) * l11 + (right * right + g->zz + low * high) * l00 + (across + diagonal) * l10;
    double upper = (left * left + g->zz + low * high) * l11 + (left * right + high2) * l00 + (across + diagonal) * l01;
    return angleOfTriangles(g->height * width * length, lower, upper);
}

double sideOfGrazing(const Grazing *g, double p, double q, double width) {
    return g->y0 < 0 ? quarterOfGrazing(g, p, q, width, 0, g->y1, g->y1) + quarterOfGrazing(g, p, q, width, 0, -g->y0, -g->y0)
                     : quarterOfGrazing(g, p, q, width, g->y0, g->y1, g->length);
}

double measureGrazing(Grazing *g, double least, double width, double low, double length, double height) {
    g->x0 = least;
    g->x1 = least + width;
    bool mirrored = low + (low + length) < 0;
    g->y0 = mirrored ? -(low + length) : low;
    g->y1 = mirrored ? -low : low + length;
    g->length = length;
    g->height = height;
    g->zz = height * height;
    if (g->x0 >= 0) {
        g->left = 0;
        g->right = sideOfGrazing(g, g->x0, g->x1, width);
    } else if (g->x1 <= 0) {
        g->left = sideOfGrazing(g, -g->x1, -g->x0, width);
        g->right = 0;
    } else {
        g->left = sideOfGrazing(g, 0, -g->x0, -g->x0);
        g->right = sideOfGrazing(g, 0, g->x1, g->x1);
    }
    g->solidAngle = g->left + g->right;
    return g->solidAngle;
}

double beyondStrip(const Grazing *g, double p, double low, double high, double length) {
    double r0 = sqrt(p * p + low * low + g->zz);
    double r1 = sqrt(p * p + high * high + g->zz);
    return 2 * angleOf(g->height * length, (r0 + p) * (r1 + p) + low * high + g->zz);
}

double beyondGrazing(const Grazing *g, double p) {
    return g->y0 < 0 ? beyondStrip(g, p, 0, g->y1, g->y1) + beyondStrip(g, p, 0, -g->y0, -g->y0)
                     : beyondStrip(g, p, g->y0, g->y1, g->length);
}

void prepareGrazing(Grazing *g) {
    g->e1 = angleOf(g->height, g->y1);
    g->obtuseEdge = g->y0 < 0;
    g->e0 = angleOf(g->height, fabs(g->y0));
    double cosine = fma(g->y0, g->y1, g->zz);
    g->obtuseStrip = cosine < 0;
    g->strip = g->obtuseStrip ? g->e1 + g->e0 : angleOf(g->height * g->length, cosine);
    double nearest = larger(larger(g->x0, -g->x1), 0);
    g->before = nearest > 0 ? sideOfGrazing(g, 0, nearest, nearest) : 0;
    g->beyondLeft = g->left > 0 ? beyondGrazing(g, -g->x0) : 0;
    g->beyondRight = g->right > 0 ? beyondGrazing(g, g->x1) : 0;
}

double distanceInGrazing(const Grazing *g, double psi, double delta) {
    double halfDelta = 0.5 * delta;
    double ofStrip = sineOf(g->obtuseStrip ? g->strip + halfDelta : g->strip - halfDelta);
    double ofEdge = sineOf(g->obtuseEdge ? g->e0 + halfDelta : g->e0 - halfDelta);
    double ofPsi = sineOf(g->obtuseStrip && delta < psi ? g->strip + delta : psi);
    double product = sineOf(halfDelta) * ofStrip;
    double edges = sineOf(g->e1 + halfDelta) * ofEdge;
    return product > 0 && edges > 0 ? 0.5 * g->height * ofPsi / (sqrt(product) * sqrt(edges)) : DBL_MAX;
}

double chooseGrazing(const Grazing *g, double u) {
    double turn = u * g->solidAngle;
    double rest = (1 - u) * g->solidAngle;
    if (turn < g->left || !(g->right > 0)) {
        double inner = g->right > 0 ? g->left - turn : rest;
        return smaller(larger(-distanceInGrazing(g, g->before + inner, g->beyondLeft + turn), g->x0), g->x1);
    }
    double inner = g->left > 0 ? turn - g->left : turn;
    return smaller(larger(distanceInGrazing(g, g->before + inner, g->beyondRight + rest), g->x0), g->x1);
}

void setSpherical(Spherical *r, double left, double width, double low, double length, double height) {
    r->x0 = left;
    r->x1 = left + width;
    r->y0 = low;
    r->y1 = low + length;
    r->height = height;
    r->width = width;
    r->length = length;
    r->zz = height * height;
    r->low2 = r->y0 * r->y0 + r->zz;
    r->high2 = r->y1 * r->y1 + r->zz;
    r->left2 = r->x0 * r->x0 + r->zz;
    r->right2 = r->x1 * r->x1 + r->zz;
}

double nearestOfSpherical(const Spherical *r) {
    double nearX = larger(larger(r->x0, -r->x1), 0);
    double nearY = larger(larger(r->y0, -r->y1), 0);
    return nearX * nearX + nearY * nearY + r->zz;
}

double farthestOfSpherical(const Spherical *r) {
    return larger(r->x0 * r->x0, r->x1 * r->x1) + larger(r->low2, r->high2);
}

void grazeSpherical(Spherical *r) {
    r->isGrazing = true;
    r->solidAngle = measureGrazing(&r->grazing, r->x0, r->width, r->y0, r->length, r->height);
}

void measureSpherical(Spherical *r) {
    r->isGrazing = r->zz < LEAST_GRAZING_COSINE * LEAST_GRAZING_COSINE * farthestOfSpherical(r);
    if (r->isGrazing) {
        grazeSpherical(r);
        return;
    }
    double l00 = sqrt(r->x0 * r->x0 + r->low2);
    double l10 = sqrt(r->x1 * r->x1 + r->low2);
    double l11 = sqrt(r->x1 * r->x1 + r->high2);
    double l01 = sqrt(r->x0 * r->x0 + r->high2);
    double across = r->x0 * r->x1 + r->y0 * r->y1 + r->zz;
    double diagonal = l00 * l11;
    double lower = (r->x0 * r->x1 + r->low2) * l11 + (r->right2 + r->y0 * r->y1) * l00 + (across + diagonal) * l10;
    double upper = (r->left2 + r->y0 * r->y1) * l11 + (r->x0 * r->x1 + r->high2) * l00 + (across + diagonal) * l01;
    r->solidAngle = angleOfTriangles(r->height * (r->width * r->length), lower, upper);
}

void prepareSpherical(Spherical *r) {
    if (!r->isGrazing && r->solidAngle < LEAST_SOLID_ANGLE) {
        grazeSpherical(r);
    }
    if (r->isGrazing) {
        prepareGrazing(&r->grazing);
        return;
    }
    r->b0 = -r->y0 / sqrt(r->low2);
    r->a0 = r->zz / r->low2;
    r->b1 = r->y1 / sqrt(r->high2);
    double a1 = r->zz / r->high2;
    double left = -r->x0 / sqrt(r->left2);
    double leftRest = r->zz / r->left2;
    double cosine1 = -r->b1 * left;
    double sine1 = sqrt(a1 + r->b1 * r->b1 * leftRest);
    double cosine0 = -left * r->b0;
    double sine0 = sqrt(leftRest + left * left * r->a0);
    r->startCosine = cosine1 * cosine0 - sine1 * sine0;
    r->startSine = -(sine1 * cosine0 + cosine1 * sine0);
}

double acrossSpherical(const Spherical *r, double u) {
    double turn = u * r->solidAngle;
    double sine = sineOf(turn);
    double cosine = cosineOf(turn);
    double f = fma(cosine * r->startCosine - sine * r->startSine, r->b0, -r->b1) / (sine * r->startCosine + cosine * r->startSine);
    double edge = sqrt(r->a0);
    double rest = (fabs(f) - edge) * (fabs(f) + edge);
    double along = rest > 0 ? copysign(r->height / sqrt(rest), f) : copysign(DBL_MAX, f);
    return smaller(larger(along, r->x0), r->x1);
}

double complementOf(double y, double dd) {
    double hypotenuse = sqrt(dd + y * y);
    return dd / (hypotenuse * (hypotenuse + fabs(y)));
}

void chooseSpherical(Spherical *r, double u, double v) {
    r->x = r->isGrazing ? chooseGrazing(&r->grazing, u) : acrossSpherical(r, u);
    double dd = r->x * r->x + r->zz;
    double low = complementOf(r->y0, dd);
    double high = complementOf(r->y1, dd);
    double less = (1 - v) * (r->y0 > 0 ? low : 2 - low) + v * (r->y1 > 0 ? high : 2 - high);
    double more = (1 - v) * (r->y0 > 0 ? 2 - low : low) + v * (r->y1 > 0 ? 2 - high : high);
    r->y = smaller(larger(0.5 * (more - less) * sqrt(dd / (less * more)), r->y0), r->y1);
}
