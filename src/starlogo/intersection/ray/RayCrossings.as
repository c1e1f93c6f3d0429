package starlogo.intersection.ray
{
    /**
     * Where a ray crosses the surface of one shape: the crossings, in any order.
     *
     * @private
     */
    public final class RayCrossings
    {
        /** A side: the ray begins inside of the shape. */
        public static const INSIDE:int = 2;

        /** A side: the ray enters the shape. */
        public static const ENTERS:int = 1;

        /** A side: the ray leaves the shape. */
        public static const LEAVES:int = -1;

        /** A side: the ray crosses a triangle from the side from which its corners are counter-clockwise. */
        public static const FRONT:int = 3;

        /** A side: the ray crosses a triangle from the other side. */
        public static const BACK:int = -3;

        /** A side: the ray runs along a triangle, from its distance to its end. */
        public static const EDGE_ON:int = 0;

        /** The number of crossings. */
        public var count:int = 0;

        /** The distance of each crossing on the ray. */
        public var distances:Vector.<Number> = new Vector.<Number>();

        /** How far the distance may be wrong because of rounding. */
        public var roundings:Vector.<Number> = new Vector.<Number>();

        /** The distance at which a triangle ends that the ray runs along. For others it is that of the crossing. */
        public var ends:Vector.<Number> = new Vector.<Number>();

        /** INSIDE, ENTERS or LEAVES. For triangles INSIDE, FRONT, BACK or EDGE_ON. */
        public var sides:Vector.<int> = new Vector.<int>();

        /** The triangle that is crossed, as the model counts them; -1 if it is none. */
        public var triangles:Vector.<int> = new Vector.<int>();

        /** The unit normal at each crossing, against the ray: x, y, z. */
        public var normals:Vector.<Number> = new Vector.<Number>();

        // A place where a ray begins, or where it enters or leaves a shape.
        private var _entry:RayEntry = new RayEntry();

        /**
         * Adds a crossing.
         *
         * @param entry has its distance, its normal and its triangle
         * @param rounding how far the distance may be wrong because of rounding
         * @param end where a triangle ends that the ray runs along; otherwise the distance
         */
        public function add(entry:RayEntry, rounding:Number, end:Number, side:int):void
        {
            distances[count] = entry.distance;
            roundings[count] = rounding;
            ends[count] = end;
            sides[count] = side;
            triangles[count] = entry.triangle;
            normals[3 * count] = entry.normalX;
            normals[3 * count + 1] = entry.normalY;
            normals[3 * count + 2] = entry.normalZ;
            count++;
        }

        /** Adds that a ray begins inside of the shape. */
        public function addInside(ray:Ray):void
        {
            _entry.setToStart(ray);
            add(_entry, 0, ray.from, INSIDE);
        }

        /**
         * Adds where a ray enters a convex shape and where it leaves it. If it begins inside, it enters where it begins. If it ends inside, it does not
         * leave.
         *
         * @param span the part of the ray's line inside of the shape
         * @param rounding how far a distance may be wrong because of rounding
         */
        public function addSpan(ray:Ray, span:RaySpan, rounding:Number):void
        {
            if (!_entry.setToEntry(ray, span))
            {
                return;
            }
            add(_entry, _entry.distance > ray.from ? rounding : 0, _entry.distance, ENTERS);
            if (_entry.setToExit(ray, span))
            {
                add(_entry, rounding, _entry.distance, LEAVES);
            }
        }

        /** Reads the distance of a crossing, with the normal and the triangle there. */
        public function readEntry(index:int, out:RayEntry):void
        {
            out.distance = distances[index];
            out.triangle = triangles[index];
            out.normalX = normals[3 * index];
            out.normalY = normals[3 * index + 1];
            out.normalZ = normals[3 * index + 2];
        }
    }
}
