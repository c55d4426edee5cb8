/** Binary trees of boxes around any items: how they are built and how rays are tested against them. */
package enlightenment.bvh;
