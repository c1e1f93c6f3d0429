package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.geometry.HalfSpaceSolver;

    /** Planes of the ground that a model is pushed out of: the shortest push out of all of them. */
    internal final class GroundPlanes
    {
        // The most planes. Three are the sides of a corner; others only separate.
        private static const CAPACITY:int = 6;

        /** The planes. Read only: a new one is written to <code>next</code>, and then added. */
        public var planes:Vector.<GroundPlane> = new Vector.<GroundPlane>();

        /** How many planes there are. Read only. */
        public var count:int = 0;

        /** The shortest push out of them. Read only. */
        public var push:HalfSpaceSolver = new HalfSpaceSolver();

        /** Where the model is tried: near the end of the push. Read only. */
        public var displacement:Vector3D = new Vector3D();

        public function GroundPlanes()
        {
            // a valley has two sides, so there may be one too many, and then the next one
            for (var i:int = 0; i < CAPACITY + 2; i++)
            {
                planes.push(new GroundPlane());
            }
        }

        /** Begins without planes. */
        public function clear():void
        {
            push.clear();
            count = 0;
            displacement.x = displacement.y = displacement.z = 0;
        }

        /** The plane that is tried. It does not count before it is added. */
        public function get next():GroundPlane
        {
            return planes[count];
        }

        /** Whether there may be another plane. */
        public function get hasRoom():Boolean
        {
            return count < CAPACITY;
        }

        /** Adds the plane that is tried. */
        public function add():void
        {
            var plane:GroundPlane = planes[count];
            push.add(plane.normal.x, plane.normal.y, plane.normal.z, plane.depth);
            count++;
        }

        /** Whether one of the planes from this one on is in the way of the displaced model, because a point of it is behind the plane. */
        public function areInWay(first:int):Boolean
        {
            for (var i:int = first; i < count; i++)
            {
                if (planes[i].frontAfter(displacement) < planes[i].offset)
                {
                    return true;
                }
            }
            return false;
        }

        /** Finds the push. Returns whether there is one. */
        public function solve():Boolean
        {
            return push.solve() && push.distance > 0;
        }

        /** Sets where the model is tried: so far behind the end of the push, or before it. */
        public function displace(farther:Number):void
        {
            var scale:Number = 1 + farther / push.distance;
            displacement.x = scale * push.displacement.x;
            displacement.y = scale * push.displacement.y;
            displacement.z = scale * push.displacement.z;
        }
    }
}
