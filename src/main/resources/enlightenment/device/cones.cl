// The cone of directions in which a ball is seen from a point: frame.BallCone, frame.Basis.
typedef struct {
    // The apex, the direction to the centre of the ball, its distance and radius, sine and cosine of the half angle.
    Vec at;
    Vec w;
    double distance;
    double radius;
    double sine;
    double cosine;
    // Whether the apex lies in the ball, so that there is no cone.
    bool inside;
} Cone;

#define CONE_ERROR GAMMA(64)

void setCone(Cone *c, double x, double y, double z, double radius, Vec at) {
    double dx = x - at.x;
    double dy = y - at.y;
    double dz = z - at.z;
    double d = sqrt(dx * dx + dy * dy + dz * dz);
    double inverse = d == 0 ? 0 : 1 / d;
    c->at = at;
    c->radius = radius;
    c->distance = d;
    c->w = vec(dx * inverse, dy * inverse, dz * inverse);
    c->inside = !(d > radius);
    if (!c->inside) {
        c->sine = radius * inverse;
        c->cosine = sqrt((d - radius) * (d + radius)) * inverse;
    }
}

double oneMinusCosine(const Cone *c) {
    return c->sine * c->sine / (1 + c->cosine);
}

// Whether another ball certainly intersects no segment from the apex to a point of this ball.
bool coneMisses(const Cone *c, double x, double y, double z, double radius) {
    if (c->inside) {
        return false;
    }
    double dx = x - c->at.x;
    double dy = y - c->at.y;
    double dz = z - c->at.z;
    double end = c->distance + c->radius;
    double along = dx * c->w.x + dy * c->w.y + dz * c->w.z;
    double slack = radius * (1 + CONE_ERROR) + CONE_ERROR * (fabs(dx) + fabs(dy) + fabs(dz) + end);
    if (along < -slack || along - slack > end) {
        return true;
    }
    double cc = dx * dx + dy * dy + dz * dz;
    double reach = slack + along * c->sine;
    double across2 = cc - along * along - CONE_ERROR * cc;
    return reach < 0 || across2 * c->cosine * c->cosine > reach * reach * (1 + CONE_ERROR);
}

// Whether another ball certainly occludes this one completely.
bool coneIsHiddenBy(const Cone *c, double x, double y, double z, double radius) {
    if (c->inside) {
        return false;
    }
    double dx = x - c->at.x;
    double dy = y - c->at.y;
    double dz = z - c->at.z;
    double cc = dx * dx + dy * dy + dz * dz;
    double r = radius * (1 - CONE_ERROR);
    double tangent = cc - r * r;
    double nearest = c->distance - c->radius;
    double onBall = 2 * CONE_ERROR;
    if (!(tangent > 2 * onBall * cc) || !(tangent < nearest * nearest * (1 - CONE_ERROR))) {
        return false;
    }
    double inverse = 1 / sqrt(cc);
    double otherSine = r * inverse;
    double otherCosine = sqrt(tangent) * inverse;
    double along = (dx * c->w.x + dy * c->w.y + dz * c->w.z) * inverse;
    return otherSine > c->sine && along > otherCosine * c->cosine + otherSine * c->sine + CONE_ERROR;
}

// Completes a unit vector to an orthonormal basis.
void setBasis(Vec w, Vec *a, Vec *b) {
    double sign = copysign(1.0, w.z);
    double p = -1 / (sign + w.z);
    double q = w.x * w.y * p;
    *a = vec(1 + sign * w.x * w.x * p, sign * q, -sign * w.x);
    *b = vec(q, sign + w.y * w.y * p, -w.y);
}
