package enlightenment.accel;

import enlightenment.primitive.Ray;

/** Finds what a ray meets first. */
public interface RaySearch {
    /** Continues a search: offers to the state every primitive that could be closer than what it has. */
    void search(Ray ray, Closest state);
}
