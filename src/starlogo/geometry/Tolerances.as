package starlogo.geometry
{
    /**
     * Every tolerance of the engine: its unit, where it comes from, and what changing it does.
     *
     * <p>All of them are relative, so that a game at any scale behaves alike. They come from two rounding errors: a
     * Number's, 1.1e-16 relative, and that of Flash Player's single-precision Matrix3D, 6e-8 relative.</p>
     */
    public final class Tolerances
    {
        /**
         * How far outside of a structure a point may lie and still count as contained, as a fraction of the structure's
         * largest extent from its middle. Larger: fits may leave more of a model out unnoticed. Below 2e-7: a structure
         * and a vertex that went through the same single-precision matrix may part.
         */
        public static const CONTAINMENT:Number = 1e-6;

        /**
         * By how much the lengths of a matrix's columns, and the angles between them, may differ from those of a turned and evenly scaled space, as
         * a fraction. Flash Player rounds the entries of a Matrix3D to single precision. Smaller: matrices that an agent itself has given are
         * refused. Larger: shear and uneven scale pass unnoticed.
         */
        public static const MATRIX:Number = 1e-5;

        /**
         * The rounding error that a position is allowed, as a fraction of its coordinates. Extents are widened by it and
         * contains() grants it. Zero: two structures that touch to the last bit may get extents that do not. Larger:
         * bins do more work; nothing else changes.
         */
        public static const ROUNDING:Number = 1e-14;

        /**
         * How far a box's axes, or the columns of a rotation, may be from unit length and from right angles, in the
         * dot products of one with another. Below 5e-7: rotations that come from a single-precision Matrix3D are
         * refused. Larger: a scaled matrix may pass for a rotation.
         */
        public static const ORTHONORMALITY:Number = 1e-5;

        /**
         * How far numbers that went through single-precision matrices may be apart and still count as one, as a fraction of
         * the largest. Such are an Away3D object's three scales, and its matrix against its traits. Below 5e-7: objects that were
         * loaded with a matrix are refused as uneven. Larger: uneven ones pass, and what is drawn differs from what collides.
         */
        public static const SINGLE_PRECISION:Number = 1e-5;

        // It is written out, to the last bit, wherever it is needed: V8 makes objects of Numbers that are passed to a function.

        /**
         * The rule of touching: how far apart shapes may be, as a fraction of the sum of all six coordinates of where they are, without their signs, and
         * still touch, because these are rounded. It holds in every collision system, for agents that stand, that sweep, and for questions about two
         * agents; for the rounding of sizes there are TOUCHING, SURFACES and NESTING. Below 2.3e-16: shapes that touch in decimals are told apart by the rounding of their places and of the middles of their shapes.
         * Larger: far out, shapes with a gap between them collide.
         */
        public static const PLACES:Number = 6e-16;

        /**
         * A factor on the distance at which structures touch: the rounding error that a test through several steps may
         * make, 1e-14 relative, and what SURFACES asks for. 1: structures that touch may, turned, be told apart by the last
         * bit. Larger: structures with a gap between them collide. The test of two Spheres compares directly; agents that are spheres are given it.
         */
        public static const TOUCHING:Number = 1 + 4e-14;

        /**
         * The squared sine of the angle below which two directions are nearly parallel, and what depends on their cross
         * product is computed by a slower method, in which nothing cancels. Smaller: answers lose digits, about 1e-16 over
         * the sine of the angle. Larger: more pairs take the slower method, with the same answers.
         */
        public static const NEARLY_PARALLEL:Number = 1e-6;

        /**
         * The squared sine of the angle below which two directions count as parallel: rounding alone turns them as far.
         * Larger than 1e-20: boxes may be told to collide across a gap of that angle times their length.
         */
        public static const PARALLEL:Number = 1e-28;

        /**
         * How far a vertex may be outside of a convex hull, as a fraction of the extent of the vertices: what rounding to
         * the hull's grid and HULL_COPLANAR come to, with room to spare. A guarantee, used by tests only.
         */
        public static const HULL:Number = 2e-7;

        /**
         * How close to a triangle of the hull a vertex above it is taken for a part of it, in steps of the hull's grid (3e-8
         * of the vertices' extent). Rounding to the grid moves both by up to 0.87 steps: below 1.8 a flat side that is
         * turned against the axes keeps dozens of vertices that are no corners. Larger: hulls get coarser.
         */
        public static const HULL_COPLANAR:Number = 2;

        /**
         * A distance from a plane beyond which its sign is right in spite of rounding, in steps of the hull's grid. Below
         * 1e-7: hulls may come out wrong. Larger: more decisions are made by the slower, exact method.
         */
        public static const HULL_CERTAIN:Number = 1e-6;

        /**
         * Up to which thickness vertices count as lying in a plane, on a line or in a point, as a fraction of their extent.
         * Larger: boxes around thin models get looser. Smaller: the rounding of a flat model is taken for its shape.
         */
        public static const HULL_FLAT:Number = 1e-12;

        /** The same as a fraction of the largest coordinate, which is what rounding depends on. */
        public static const HULL_ROUNDING:Number = 1e-14;

        /**
         * When the hull's grid is turned along the vertices: when they fill less than this share of their axis-aligned box.
         * Smaller: thin models that are turned lose precision. Larger: models with flat sides along the axes, whose
         * vertices stay exactly coplanar on a grid that is not turned, may be put on one that is.
         */
        public static const HULL_THIN:Number = 0.02;

        /**
         * The fraction by which a box must be smaller to replace one found before. Zero: rounding decides between rotations
         * that are equally good. Larger: fits get looser by as much.
         */
        public static const FIT_TIE:Number = 1e-9;

        /**
         * How far a point may be outside of the sphere through others that is tried as the smallest, as a fraction of its squared
         * radius. Below 1e-14: rounding may leave no sphere that holds all. Larger: smallest spheres get larger by as much.
         */
        public static const BALL_SLACK:Number = 1e-12;

        /**
         * When points are as good as in one plane, on one line or in one place with others, so that no sphere is laid through
         * them all: the share of a squared distance that is left across those others. Larger: smallest spheres of points that are
         * nearly flat may be missed. Smaller: centres far away, that are nothing but rounding, are tried.
         */
        public static const BALL_SINGULAR:Number = 1e-13;

        /**
         * The fraction by which the squared radius of the smallest sphere must grow with a point for it to be outside. Zero: the
         * search may go round in circles. Larger: points are found to be inside that are not, by half as much.
         */
        public static const BALL_GAIN:Number = 1e-14;

        /**
         * How close two corners of a hull are one corner of its outline, as a fraction of the hull's extent: edges that are seen
         * end on. Below 1e-14: their directions are nothing but rounding. Above 3e-8, the hull's grid: corners of the outline are lost.
         */
        public static const OUTLINE_SAME:Number = 1e-11;

        /**
         * The sine of the angle up to which an edge of an outline leads straight back. Smaller: rounding may send a walk round
         * the outline back along a side seen edge on. Larger: outlines with corners as sharp as that are walked wrongly.
         */
        public static const OUTLINE_BACK:Number = 1e-9;

        /** The slope up to which an edge of an outline is level: rounding may tilt it as much. */
        public static const OUTLINE_LEVEL:Number = 1e-12;

        /**
         * The gap across which the surfaces of two models still touch, as a fraction of the sum of the radii of spheres
         * around both. What represents a model, the nodes of its hierarchy and fitted boxes and capsules alike, is wider than
         * the model by as much, so that it touches what the surface touches; spheres are given it by TOUCHING, which must be
         * 1 + 4 times this at least. Smaller than 2e-15: surfaces that touch may, turned, be told apart by rounding. Larger:
         * surfaces with a gap between them collide.
         */
        public static const SURFACES:Number = 1e-14;

        /**
         * How much wider the nodes of a hierarchy's level are than those of the next, as a fraction of the model's radius, down
         * to level 64. Smaller than 1e-15: rounding may let children meet what their parents do not, so that a greater depth
         * finds more than a smaller one. Larger: as for SURFACES, 64 times.
         */
        public static const NESTING:Number = 2e-15;

        /**
         * The level of a hierarchy down to which nodes are wider than those of the next: see NESTING. Smaller: a greater depth may find more
         * than a smaller one below it. Larger: all nodes are wider, by NESTING for each level.
         */
        public static const NESTED_LEVELS:int = 64;

        /**
         * By how much a model may be larger than another and still be placed in the other's space, a factor: else the other one is placed
         * in its space, or is a point of it. Larger than 1e50: products of six lengths overflow. Smaller than 1e17: models are taken for
         * points whose extent is more than rounding.
         */
        public static const MUCH_LARGER:Number = 1e40;

        /**
         * How close corners of triangles are taken for one when a surface is looked at as a whole, as a fraction of the
         * model's largest coordinate. Smaller than 2.1e-7: seams between corners that were rounded to single precision may
         * stay open, and the model has no inside. Larger: features as small as that are closed over.
         */
        public static const WELDING:Number = 2.5e-7;

        /**
         * The squared height of a triangle, as a fraction of its squared longest edge, below which it is a segment: its
         * normal is then rounding error. Larger: triangles that are needles lose their width.
         */
        public static const FLAT_TRIANGLE:Number = 1e-24;

        /**
         * How far off another triangle's plane a corner must be for its side to be certain: the square of a factor on the distance at
         * which surfaces touch. Smaller: rounding may decide where the plane cuts the triangle's edges. Larger: more pairs of triangles
         * are tried on all axes, with the same answers.
         */
        public static const CLEARLY_OFF_PLANE:Number = 1e14;

        /**
         * One over the squared sine of the angle at a triangle's first corner up to which it is no needle. Larger: normals with as many
         * digits less decide. Smaller: more pairs of triangles are tried on all axes, with the same answers.
         */
        public static const SLIMMEST_TRIANGLE:Number = 1e6;

        /**
         * What these two leave uncertain of where triangles cut the line that their planes have in common, as a fraction of how far they
         * go along it. Smaller: triangles that pass each other may be said to meet. Larger: more pairs are tried on all axes.
         */
        public static const UNSURE_ON_LINE:Number = 1e-4;

        /**
         * How near to an edge of a triangle a ray may pass before its crossing is not trusted and another ray is tried, as
         * a fraction of the model's radius. Smaller than 1e-14: rounding may count a crossing twice, or not at all.
         * Larger: more rays are tried, with the same answers. Where seams were welded it is no less than their gaps.
         */
        public static const GRAZING:Number = 1e-10;

        /**
         * How far apart two closest points must be for the line between them to give the normal of a contact, as a fraction of the
         * structures' size; and the sine of the angle up to which edges are parallel to each other or to a face for it. Smaller: normals
         * are off by 1e-16 over it. Larger: depths are, by as much.
         */
        public static const DIRECTION:Number = 1e-9;

        /**
         * The squared sine of the angle to z up to which an axis is upright: the normal at right angles to it is then along x, else as
         * upright as can be. Below 1e-14: that normal has no digits left. Larger: normals jump where axes are as far from upright.
         */
        public static const UPRIGHT:Number = 1e-6;

        /**
         * How much later a second computation of a time of impact may put it than the first did, as a fraction of the motion. Smaller: rounding may
         * have the contact of two models taken for that of the structures around them. Larger: a later touch may be taken for the first.
         */
        public static const SAME_TIME:Number = 1e-9;

        /**
         * How far the depth of a contact may be off, as a fraction of the larger extent of the two that touch: moved by as much more they are
         * apart, by as much less they still touch. Smaller than 1e-12: rounding along directions that are nearly level with a surface is more.
         */
        public static const SEPARATION:Number = 1e-9;

        /**
         * The sine of the angle by which a place may be outside of a cone's border and still be in the cone. Below 1e-15: rounding decides about places
         * at the border. Larger: cones are wider by as much.
         */
        public static const CONE:Number = 2e-14;

        /**
         * The squared length up to which a motion is free whatever is in its way: the squares of its parts have no digits left. Below 1e-300: directions
         * are lost. Larger: agents may be put as deep as that into others.
         */
        public static const VANISHING:Number = 1e-290;

        /**
         * A factor on shapes that are tried before those that decide. Below 1 + 1e-14: rounding lets them separate shapes that touch. Larger: they decide
         * less often.
         */
        public static const OUTER:Number = 1 + 1e-12;

        /**
         * How much wider the boxes are by which questions find agents, as a fraction of their size; besides, EXTENTS_GAPS times what PLACES makes of their places.
         * Below 1e-14: agents that touch by rounding may not be found. Larger: more are looked at.
         */
        public static const EXTENTS:Number = 1e-13;

        /** See EXTENTS. */
        public static const EXTENTS_GAPS:Number = 100;

        /**
         * How far apart structures are, as a fraction of their size, that certainly do not touch. Below 1e-13: rounding may give those that touch a
         * distance. Larger: more pairs are tested for touching as well.
         */
        public static const APART:Number = 1e-9;

        /** Tolerances are constants; there are no instances. */
        public function Tolerances()
        {
        }
    }
}
