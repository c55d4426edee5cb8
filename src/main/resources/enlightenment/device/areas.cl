// Lights of physical shading as a vertex sees them: emitter.SphereLight, ParallelogramLight, LightSample and transport.direct.LightView.
#define UNDECIDED 0
#define ABSENT 1
#define BY_AREA 2
#define BY_SOLID_ANGLE 3

#define FRONT_SHINES 0
#define BOTH_SHINE 1

#define UNIT_RIGHT 16
#define UNIT_UP 19
#define LIGHT_NORMAL 22
#define LIGHT_WIDTH 25
#define LIGHT_LENGTH 26
#define LIGHT_AREA 27
#define END_TOLERANCE 28

typedef struct {
    // Cone around its ball; direction and distance of the last point.
    View view;
    __global const int *light;
    // The signed distance of the vertex from the plane of a flat light.
    double height;
    int choice;
    Spherical r;
    // The density of the last point, per solid angle.
    double pdf;
} Seen;

double along(__global const double *v, double x, double y, double z) {
    return fusedDot(v[0], v[1], v[2], x, y, z);
}

void lookAt(const Scene *s, Seen *v, int index, Vec p) {
    aim(s, &v->view, index, p);
    v->light = lightOf(s, index);
    v->choice = UNDECIDED;
    if (v->view.kind == RECTANGLE_LIGHT) {
        __global const double *q = v->view.q;
        v->height = -along(q + LIGHT_NORMAL, q[7] - p.x, q[8] - p.y, q[9] - p.z);
    } else if (v->view.kind == POINT_LIGHT) {
        v->view.d = v->view.cone.w;
        v->view.length = v->view.cone.distance;
    }
}

bool shinesAt(const Seen *v, double cosine) {
    int sides = v->light[LIGHT_SIDES];
    return sides == FRONT_SHINES ? cosine > 0 : sides == BOTH_SHINE ? cosine != 0 : cosine < 0;
}

double leastAlong(const Seen *v, int edge) {
    __global const double *q = v->view.q;
    Vec at = v->view.cone.at;
    return along(q + edge, q[7] - at.x, q[8] - at.y, q[9] - at.z);
}

int choiceOf(Seen *v) {
    if (v->choice != UNDECIDED) {
        return v->choice;
    }
    if (!shinesAt(v, v->height)) {
        return v->choice = ABSENT;
    }
    __global const double *q = v->view.q;
    setSpherical(&v->r, leastAlong(v, UNIT_RIGHT), q[LIGHT_WIDTH], leastAlong(v, UNIT_UP), q[LIGHT_LENGTH], fabs(v->height));
    double nearest = nearestOfSpherical(&v->r);
    double farthest = farthestOfSpherical(&v->r);
    if (farthest <= 1.25 * nearest) {
        return v->choice = BY_AREA;
    }
    measureSpherical(&v->r);
    bool uneven = farthest > 2 * nearest && v->r.solidAngle > 1e-9;
    if (v->r.solidAngle < LEAST_SOLID_ANGLE && !uneven) {
        return v->choice = BY_AREA;
    }
    prepareSpherical(&v->r);
    return v->choice = BY_SOLID_ANGLE;
}

double densityByArea(const Seen *v, double distance, double cosine) {
    if (!shinesAt(v, cosine)) {
        return 0;
    }
    double density = distance * distance / (v->view.q[LIGHT_AREA] * fabs(cosine));
    return density <= DBL_MAX ? density : 0;
}

double densityOfBall(const Seen *v) {
    double density = 1 / (2 * PI * oneMinusCosine(&v->view.cone));
    return density <= DBL_MAX ? density : 0;
}

void toOffset(Seen *v, double x, double y, double z) {
    double length = sqrt(x * x + y * y + z * z);
    double inverse = length > 0 ? 1 / length : 0;
    v->view.d = vec(x * inverse, y * inverse, z * inverse);
    v->view.length = length;
}

// Samples a point of a light with extent.
void samplePoint(Seen *v, double2 u) {
    if (v->view.kind == BALL_LIGHT) {
        v->pdf = 0;
        if (!v->view.cone.inside) {
            sampleLight(&v->view, u.x, u.y);
            v->pdf = densityOfBall(v);
        }
        return;
    }
    __global const double *q = v->view.q;
    int choice = choiceOf(v);
    if (choice == BY_SOLID_ANGLE) {
        chooseSpherical(&v->r, u.x, u.y);
        double x = v->r.x;
        double y = v->r.y;
        double down = -v->height;
        toOffset(v, fusedDot(q[UNIT_RIGHT], q[UNIT_UP], q[LIGHT_NORMAL], x, y, down),
                fusedDot(q[UNIT_RIGHT + 1], q[UNIT_UP + 1], q[LIGHT_NORMAL + 1], x, y, down),
                fusedDot(q[UNIT_RIGHT + 2], q[UNIT_UP + 2], q[LIGHT_NORMAL + 2], x, y, down));
        v->pdf = 1 / v->r.solidAngle;
    } else if (choice == BY_AREA) {
        Vec at = v->view.cone.at;
        toOffset(v, fma(u.x, q[10], fma(u.y, q[13], q[7] - at.x)), fma(u.x, q[11], fma(u.y, q[14], q[8] - at.y)),
                fma(u.x, q[12], fma(u.y, q[15], q[9] - at.z)));
        v->pdf = densityByArea(v, v->view.length, v->height / v->view.length);
    } else {
        v->pdf = 0;
    }
}

// The density with which the light would be sampled where a ray has hit it.
double densityOfHit(Seen *v, const Ray *ray, const Hit *hit) {
    if (v->view.kind == BALL_LIGHT) {
        return v->view.cone.inside ? 0 : densityOfBall(v);
    }
    Vec at = v->view.cone.at;
    double dx = hit->p.x - at.x;
    double dy = hit->p.y - at.y;
    double dz = hit->p.z - at.z;
    double distance = sqrt(dx * dx + dy * dy + dz * dz);
    double scale = 1 / sqrt(ray->dd);
    double cosine = -(hit->n.x * ray->dx + hit->n.y * ray->dy + hit->n.z * ray->dz) * scale;
    int choice = choiceOf(v);
    return choice == BY_SOLID_ANGLE ? 1 / v->r.solidAngle : choice == BY_AREA ? densityByArea(v, distance, cosine) : 0;
}

// The irradiance that nothing hides, for radiance 1; NaN from inside of a ball.
double irradianceOf(const Seen *v, Vec n) {
    if (v->view.kind == BALL_LIGHT) {
        return v->view.cone.inside ? NAN : irradianceOfSphere(&v->view.cone, n);
    }
    if (!shinesAt(v, v->height)) {
        return 0;
    }
    __global const double *q = v->view.q;
    bool far = 2 * q[6] < 0x1p-9 * v->view.cone.distance;
    if (!far) {
        double e = irradianceOfWhole(leastAlong(v, UNIT_RIGHT), q[LIGHT_WIDTH], leastAlong(v, UNIT_UP), q[LIGHT_LENGTH], -v->height,
                along(q + UNIT_RIGHT, n.x, n.y, n.z), along(q + UNIT_UP, n.x, n.y, n.z), along(q + LIGHT_NORMAL, n.x, n.y, n.z));
        if (e == e) {
            return e;
        }
    }
    Vec at = v->view.cone.at;
    return irradianceOfParallelogram(vec(q[7] - at.x, q[8] - at.y, q[9] - at.z), vecAt(q + 10), vecAt(q + 13), n, fabs(v->height), far);
}

// Whether light of a rectangle may reach a surface with this normal.
bool reachesSurface(const Seen *v, Vec n) {
    if (!shinesAt(v, v->height)) {
        return false;
    }
    __global const double *q = v->view.q;
    Vec at = v->view.cone.at;
    double base = n.x * (q[7] - at.x) + n.y * (q[8] - at.y) + n.z * (q[9] - at.z);
    double across = n.x * q[10] + n.y * q[11] + n.z * q[12];
    double upwards = n.x * q[13] + n.y * q[14] + n.z * q[15];
    return base + larger(across, 0) + larger(upwards, 0) > 0;
}
