// The colour along one camera ray by the paper's cosine shading: classic.shading.ClassicShader and ClassicDirectLight, with what they need of
// transport.ray.PathFollower, GlassTracer and MediumStack. Where surfaces touch, where a ray is too large or too small, and where glass is
// nested too deeply, the sample is left to the host.

typedef struct {
    Sampler sampler;
    // The surfaces left behind.
    int surfaces;
    int bounces;
    int straight;
    Solids solids;
    Ray ray;
    Hit hit;
    // The normal that the surface is shaded by, to its outside; another than its own where it is smooth.
    Vec normal;
    bool isSmooth;
    Vec throughput;
    Vec light;
} Path;

bool isBlocked(Scene *s, const Path *path, const View *view, int hierarchy) {
    Ray shadow;
    const Hit *hit = &path->hit;
    Closest best;
    best.id = NOTHING;
    if (path->isSmooth) {
        Vec o = bulgeOf(s, hit);
        setRay(s, &shadow, hit->p.x + o.x, hit->p.y + o.y, hit->p.z + o.z, fma(view->d.x, view->length, -o.x),
                fma(view->d.y, view->length, -o.y), fma(view->d.z, view->length, -o.z), 0);
        best.t = 1;
    } else {
        setRay(s, &shadow, hit->p.x, hit->p.y, hit->p.z, view->d.x, view->d.y, view->d.z, 0);
        best.t = view->length;
    }
    startOn(&shadow, hit, hit->side);
    s->shadowRays++;
    return search(s, &shadow, true, hierarchy, &best);
}

// Whether anything may be in the way of shadow rays to the light.
bool needsRays(const Scene *s, const Path *path, const View *view, int hierarchy) {
    Vec from = path->hit.p;
    if (path->isSmooth) {
        Vec o = bulgeOf(s, &path->hit);
        from = vec(from.x + o.x, from.y + o.y, from.z + o.z);
    }
    Shaft shaft;
    return !setShaft(&shaft, from, view->q + 3, path->hit.id, path->hit.side) || mayBeBlocked(s, &shaft, hierarchy);
}

// The mean over light points of (visible ? 1 : keeps) · cosθ at the hit.
double lightMean(Scene *s, const Path *path, Vec n, int index, double keeps) {
    View view;
    int hierarchy = lightOf(s, index)[LIGHT_HIERARCHY];
    aim(s, &view, index, path->hit.p);
    int count = view.kind == POINT_LIGHT ? 1 : s->i[LIGHT_POINTS];
    s->lightSamples += count;
    double unshadowed = meanCosine(&view, n);
    if (unshadowed == 0) {
        return 0;
    }
    bool known = unshadowed == unshadowed;
    bool rays = keeps < 1 && needsRays(s, path, &view, hierarchy);
    if (!rays && known) {
        return unshadowed;
    }
    ulong seed = seedOfLight(&path->sampler, index, path->surfaces);
    uint first = shuffledIndex(path->sampler.sample, mixed(seed)) * (uint) count;
    if (!known) {
        double sum = 0;
        for (int j = 0; j < count; j++) {
            sampleLight(&view, sobolX(first + j, seed), sobolY(first + j, seed));
            double cosine = n.x * view.d.x + n.y * view.d.y + n.z * view.d.z;
            if (cosine > 0) {
                sum += rays && isBlocked(s, path, &view, hierarchy) ? keeps * cosine : cosine;
            }
        }
        return sum / count;
    }
    prepareByCosine(&view, n);
    int blocked = 0;
    for (int j = 0; j < count; j++) {
        sampleByCosine(&view, sobolX(first + j, seed), sobolY(first + j, seed));
        blocked += isBlocked(s, path, &view, hierarchy) ? 1 : 0;
    }
    if (blocked == count) {
        return keeps * unshadowed;
    }
    return fma(-((1 - keeps) * unshadowed), (double) blocked / count, unshadowed);
}

void addLight(Path *path, double r, double g, double b) {
    path->light.x = fma(path->throughput.x, r, path->light.x);
    path->light.y = fma(path->throughput.y, g, path->light.y);
    path->light.z = fma(path->throughput.z, b, path->light.z);
}

void filterBy(Path *path, Vec color, double share) {
    path->throughput.x *= color.x * share;
    path->throughput.y *= color.y * share;
    path->throughput.z *= color.z * share;
}

// Adds the light that the surface itself reflects, times a share.
void shadeSurface(Scene *s, Path *path, __global const int *material, Vec color, double share) {
    int lights = s->i[LIGHT_COUNT];
    double ambient = s->d[AMBIENT];
    if (lights == 0) {
        double factor = ambient * share;
        addLight(path, color.x * factor, color.y * factor, color.z * factor);
        return;
    }
    int side = path->hit.side;
    Vec n = vec(path->normal.x * side, path->normal.y * side, path->normal.z * side);
    double keeps = material[RECEIVES_SHADOWS] != 0 ? s->d[SHADOW] : 1;
    Vec sum = vec(0, 0, 0);
    for (int k = 0; k < lights && s->state == DONE; k++) {
        double factor = fma(1 - ambient, lightMean(s, path, n, k, keeps), ambient);
        __global const double *q = s->d + lightOf(s, k)[LIGHT_NUMBERS];
        sum.x += q[0] * factor;
        sum.y += q[1] * factor;
        sum.z += q[2] * factor;
    }
    double count = lights;
    addLight(path, color.x * (sum.x * share) / count, color.y * (sum.y * share) / count, color.z * (sum.z * share) / count);
}

// Lets the ray leave the hit to the mirror image of where it came from, or to where it is refracted; whether it was refracted.
bool turn(Scene *s, Path *path, double eta, bool mayRefract) {
    Ray *r = &path->ray;
    const Hit *hit = &path->hit;
    double scale = 1 / sqrt(r->dd);
    double ox = -r->dx * scale;
    double oy = -r->dy * scale;
    double oz = -r->dz * scale;
    double nx = hit->n.x * hit->side;
    double ny = hit->n.y * hit->side;
    double nz = hit->n.z * hit->side;
    double cosine = ox * nx + oy * ny + oz * nz;
    double x;
    double y;
    double z;
    bool through = false;
    if (mayRefract) {
        double etaCos = eta * smaller(larger(cosine, 0), 1);
        double cos2 = fma(etaCos, etaCos, (1 - eta) * (1 + eta));
        through = cos2 >= 0;
        if (through) {
            double along = etaCos - sqrt(cos2);
            x = fma(along, nx, -eta * ox);
            y = fma(along, ny, -eta * oy);
            z = fma(along, nz, -eta * oz);
        }
    }
    if (!through) {
        double twice = 2 * cosine;
        x = twice * nx - ox;
        y = twice * ny - oy;
        z = twice * nz - oz;
    }
    double unit = 1 / sqrt(x * x + y * y + z * z);
    setRay(s, r, hit->p.x, hit->p.y, hit->p.z, x * unit, y * unit, z * unit, 0);
    startOn(r, hit, through ? -hit->side : hit->side);
    return through;
}

// Crosses a surface of glass; whether the path has one more event.
void crossGlass(Scene *s, Path *path, __global const int *material, bool *passedStraight) {
    Ray *r = &path->ray;
    const Hit *hit = &path->hit;
    bool isSolid = primitive(s, hit->id)[IS_SOLID] != 0;
    int from = mediumOf(s, &path->solids);
    Solids before = path->solids;
    if (isSolid) {
        crossBorder(s, &path->solids, hit->id, hit->side);
    }
    int to = mediumOf(s, &path->solids);
    bool isBorder = from != to;
    double fromIndex = indexOf(s, from);
    double toIndex = indexOf(s, to);
    bool straight = !isBorder || fromIndex == toIndex;
    bool through = true;
    if (straight) {
        setRay(s, r, hit->p.x, hit->p.y, hit->p.z, r->dx, r->dy, r->dz, 0);
        startOn(r, hit, -hit->side);
    } else {
        through = turn(s, path, fromIndex / toIndex, true);
        if (through) {
            s->refractedRays++;
        } else {
            s->mirrorRays++;
            path->solids = before;
        }
    }
    *passedStraight = straight;
    if (isBorder || through && !isSolid) {
        Vec color = colorAt(s, hit, material);
        double clear = s->d[material[MATERIAL_NUMBERS] + 8];
        if (clear < 1) {
            shadeSurface(s, path, material, color, 1 - clear);
        }
        if (through) {
            filterBy(path, color, clear);
        } else {
            path->throughput.x *= clear;
            path->throughput.y *= clear;
            path->throughput.z *= clear;
        }
    }
}

// Follows the ray to the next event; whether the path continues.
bool follow(Scene *s, Path *path) {
    Closest best;
    best.t = DBL_MAX;
    best.id = NOTHING;
    search(s, &path->ray, false, 0, &best);
    int light = NOTHING;
    for (int k = 0; k < s->i[LIGHT_COUNT]; k++) {
        int surface = lightOf(s, k)[LIGHT_SURFACE];
        double t = surface < 0 ? MISS : nearestOf(s, surface, &path->ray, best.t, false);
        if (t < best.t) {
            best.t = t;
            light = k;
        }
    }
    if (light != NOTHING) {
        __global const double *q = s->d + lightOf(s, light)[LIGHT_NUMBERS];
        addLight(path, q[0], q[1], q[2]);
        return false;
    }
    if (best.id == NOTHING) {
        addLight(path, s->d[BACKGROUND], s->d[BACKGROUND + 1], s->d[BACKGROUND + 2]);
        return false;
    }
    path->ray.element = best.element;
    completeOf(s, best.id, &path->ray, best.t, &path->hit);
    if (touchesOther(s, &path->hit)) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    __global const int *material = materialAt(s, &path->hit);
    bool passedStraight = false;
    path->normal = path->hit.n;
    path->isSmooth = material[MATERIAL_KIND] != GLASS && shadingNormal(s, &path->hit, &path->normal);
    if (path->isSmooth && material[MATERIAL_KIND] == MIRROR) {
        s->state = LEFT_TO_HOST;
        return false;
    }
    if (material[MATERIAL_KIND] == GLASS) {
        crossGlass(s, path, material, &passedStraight);
    } else {
        Vec color = colorAt(s, &path->hit, material);
        if (material[MATERIAL_KIND] == MATTE) {
            shadeSurface(s, path, material, color, 1);
            return false;
        }
        s->mirrorRays++;
        turn(s, path, 1, false);
        filterBy(path, color, 1);
        if (isInGlassBox(s, path->hit.p)) {
            s->state = LEFT_TO_HOST;
        }
    }
    if (!(path->throughput.x > 0 || path->throughput.y > 0 || path->throughput.z > 0)) {
        return false;
    }
    path->surfaces++;
    if (passedStraight) {
        return ++path->straight <= s->i[MAX_STRAIGHT];
    }
    path->straight = 0;
    return ++path->bounces <= s->i[MAX_BOUNCES];
}

void beginPath(Path *path) {
}
