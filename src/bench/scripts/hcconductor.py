"""A BSDF for Mitsuba 3: GGX conductor with height-correlated masking and no compensation of multiple scattering, as the reference of the metals has it.

D(m) G2(i, o, m) F(i·m) / (4 cos i cos o) with D of Trowbridge and Reitz (Walter et al., 2007), G2 = 1/(1 + Λ(i) + Λ(o)) (Heitz, "Understanding the
Masking-Shadowing Function", 2014), the unpolarized Fresnel equations of a conductor with η and k per band, and half vectors among those that are visible
(Heitz, "Sampling the GGX Distribution of Visible Normals", 2018), so that a sample weighs F G2/G1(i). Mitsuba's own `roughconductor` multiplies two
separate maskings G1(i) G1(o) instead: darker where both directions graze.

    <bsdf type="hcconductor"><float name="alpha" value="0.16"/><vector name="eta" value="..."/><vector name="k" value="..."/></bsdf>

`register()` after a variant was set, before a scene is loaded.
"""
import drjit as dr
import mitsuba as mi


def register():
    mi.register_bsdf("hcconductor", make_class())


def square(v):
    return v * v


def make_class():
    """Of the variant that is set: Mitsuba's classes are others in each."""

    class HeightCorrelatedConductor(mi.BSDF):
        def __init__(self, props):
            mi.BSDF.__init__(self, props)
            self.alpha = float(props["alpha"])
            self.eta = mi.Color3f([float(v) for v in props["eta"]])
            self.k = mi.Color3f([float(v) for v in props["k"]])
            flags = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide
            self.m_components = [flags]
            self.m_flags = flags

        def stretched(self, v):
            """(α x)² + (α y)² over z²: the squared tangent by which Λ and D go."""
            return square(self.alpha) * (square(v.x) + square(v.y)) / square(v.z)

        def masking(self, v):
            return 0.5 * (dr.sqrt(1 + self.stretched(v)) - 1)

        def distribution(self, m):
            a2 = square(self.alpha)
            # 1 + (a² - 1) cos² in a form that loses nothing near the peak.
            return a2 / (dr.pi * square(square(m.x) + square(m.y) + a2 * square(m.z)))

        def fresnel(self, c):
            """Reflectance of unpolarized light at a conductor, exact."""
            c2 = square(c)
            s2 = 1 - c2
            eta2, k2 = square(self.eta), square(self.k)
            t0 = eta2 - k2 - s2
            both = dr.sqrt(square(t0) + 4 * eta2 * k2)
            a = dr.sqrt(dr.maximum(0.5 * (both + t0), 0))
            perpendicular = (both + c2 - 2 * a * c) / (both + c2 + 2 * a * c)
            far = c2 * both + square(s2)
            parallel = perpendicular * (far - 2 * a * c * s2) / (far + 2 * a * c * s2)
            return 0.5 * (perpendicular + parallel)

        def visible(self, v, sample):
            """A half vector in proportion to max(v·m, 0) D(m) / (1 + Λ(v))."""
            a = self.alpha
            h = dr.normalize(mi.Vector3f(a * v.x, a * v.y, v.z))
            length = square(h.x) + square(h.y)
            inverse = dr.rsqrt(dr.maximum(length, 1e-30))
            t1 = dr.select(length > 0, mi.Vector3f(-h.y * inverse, h.x * inverse, 0), mi.Vector3f(1, 0, 0))
            t2 = dr.cross(h, t1)
            r, phi = dr.sqrt(sample.x), 2 * dr.pi * sample.y
            sin, cos = dr.sincos(phi)
            p1, s = r * cos, 0.5 * (1 + h.z)
            p2 = dr.lerp(dr.sqrt(dr.maximum(1 - square(p1), 0)), r * sin, s)
            m = p1 * t1 + p2 * t2 + dr.sqrt(dr.maximum(1 - square(p1) - square(p2), 0)) * h
            return dr.normalize(mi.Vector3f(a * m.x, a * m.y, dr.maximum(m.z, 0)))

        def density(self, wi, m):
            """Of the outgoing direction: the half vector's, over 4 i·m."""
            return self.distribution(m) / (4 * wi.z * (1 + self.masking(wi)))

        def sample(self, ctx, si, sample1, sample2, active):
            wi = si.wi
            m = self.visible(wi, sample2)
            cosine = dr.dot(wi, m)
            bs = mi.BSDFSample3f()
            bs.wo = 2 * cosine * m - wi
            bs.eta = 1.0
            bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
            bs.sampled_component = mi.UInt32(0)
            active = active & (wi.z > 0) & (bs.wo.z > 0) & (cosine > 0)
            bs.pdf = dr.select(active, self.density(wi, m), 0)
            i, o = self.masking(wi), self.masking(bs.wo)
            weight = self.fresnel(cosine) * ((1 + i) / (1 + i + o))
            return bs, dr.select(active, weight, mi.Color3f(0))

        def eval_pdf(self, ctx, si, wo, active):
            wi = si.wi
            active = active & (wi.z > 0) & (wo.z > 0)
            m = dr.normalize(wi + wo)
            cosine = dr.dot(wi, m)
            active = active & (cosine > 0)
            d, i, o = self.distribution(m), self.masking(wi), self.masking(wo)
            value = self.fresnel(cosine) * (d / (4 * wi.z * (1 + i + o)))
            return dr.select(active, value, mi.Color3f(0)), dr.select(active, self.density(wi, m), 0)

        def eval(self, ctx, si, wo, active):
            return self.eval_pdf(ctx, si, wo, active)[0]

        def pdf(self, ctx, si, wo, active):
            return self.eval_pdf(ctx, si, wo, active)[1]

        def to_string(self):
            return f"HeightCorrelatedConductor[alpha={self.alpha}, eta={self.eta}, k={self.k}]"

    return HeightCorrelatedConductor
