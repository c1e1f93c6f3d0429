package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.solid.SupportPoint;

    /**
     * A plane of the ground, and the point of a model that is farthest behind it, as a record. The exit of this point leads along the normal to the plane. All is
     * relative to the search's origin.
     */
    internal final class GroundPlane
    {
        /** A unit vector out of the ground, and the component of the plane's points along it. */
        public var normal:Vector3D = new Vector3D(0, 0, 1);
        public var offset:Number = 0;

        /** The point. Its support is along the reversed normal. */
        public var point:SupportPoint = new SupportPoint();

        /** Whether the point is surely one of the model. A tree need not have points between two of its own. */
        public var isPointOfModel:Boolean = true;

        private var _inwards:Vector3D = new Vector3D();

        /** Becomes the same as another plane. */
        public function copyFrom(other:GroundPlane):void
        {
            normal.copyFrom(other.normal);
            offset = other.offset;
            point.copyFrom(other.point);
            isPointOfModel = other.isPointOfModel;
        }

        /** Finds the point of a model that is farthest behind the plane. */
        public function findPoint(model:ModelPiece):void
        {
            _inwards.x = -normal.x;
            _inwards.y = -normal.y;
            _inwards.z = -normal.z;
            model.findFarthest(_inwards, point);
            isPointOfModel = true;
        }

        /** How deep the model is behind the plane. It is negative if all of the model is in front. */
        public function get depth():Number
        {
            return offset + point.support;
        }

        /** How far along the normal all of the model is, after it has moved by a vector. */
        public function frontAfter(by:Vector3D):Number
        {
            return normal.x * by.x + normal.y * by.y + normal.z * by.z - point.support;
        }

        /** How far the point is under the ground after it has moved by a vector. Negative above it; NaN where there is no ground. */
        public function depthUnderGround(search:GroundSearch, by:Vector3D):Number
        {
            return search.grid.heightAt(point.x + by.x + search.origin.x, point.y + by.y + search.origin.y) - (point.z + by.z + search.origin.z);
        }
    }
}
