package starlogo.ground
{
    import flash.geom.Vector3D;

    /** A triangle of the ground's slopes, or the top of a block, as far as it is under a box, as a record. */
    internal final class GroundFacet
    {
        /** The first corner of the cell, with the least x and y, relative to the search's origin. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** How much it rises in a patch along x, and along y. */
        public var riseX:Number = 0;
        public var riseY:Number = 0;

        /** The part of the cell under the box, relative to the corner: a rectangle. */
        public var minX:Number = 0;
        public var minY:Number = 0;
        public var maxX:Number = 0;
        public var maxY:Number = 0;

        /** How wide the cell is, and whether the triangle is at its side with the greatest x, or at the one with the greatest y. */
        public var width:Number = 0;
        public var isBesideX:Boolean = false;

        /**
         * An upper bound of the components of its points along a vector that does not point down: the lesser one of the bounds of the triangle and of the
         * rectangle in its plane.
         */
        public function maxAlong(vector:Vector3D):Number
        {
            var slopeX:Number = vector.x + vector.z * riseX;
            var slopeY:Number = vector.y + vector.z * riseY;
            var toX:Number = slopeX > 0 ? maxX : minX;
            var toY:Number = slopeY > 0 ? maxY : minY;
            var ofRectangle:Number = slopeX * toX + slopeY * toY;
            var ofSide:Number = isBesideX ? slopeX : slopeY;
            var ofDiagonal:Number = slopeX + slopeY;
            ofSide = ofSide > ofDiagonal ? ofSide : ofDiagonal;
            var ofTriangle:Number = ofSide > 0 ? width * ofSide : 0;
            var most:Number = ofTriangle < ofRectangle ? ofTriangle : ofRectangle;
            return vector.x * x + vector.y * y + vector.z * z + most;
        }

        /** Writes its plane. */
        public function writePlane(out:GroundPlane):void
        {
            var length:Number = Math.sqrt(riseX * riseX + riseY * riseY + 1);
            out.normal.x = -riseX / length;
            out.normal.y = -riseY / length;
            out.normal.z = 1 / length;
            out.offset = out.normal.x * x + out.normal.y * y + out.normal.z * z;
        }

        /**
         * Writes a plane that may be between the facet and a box above it. It is perpendicular to the way from the facet to the box's middle.
         *
         * @return whether there is one
         */
        public function writePlaneBelow(box:GroundBox, out:GroundPlane):Boolean
        {
            var toX:Number = box.x - x;
            var toY:Number = box.y - y;
            var nearX:Number = toX < minX ? minX : toX;
            var nearY:Number = toY < minY ? minY : toY;
            nearX = nearX > maxX ? maxX : nearX;
            nearY = nearY > maxY ? maxY : nearY;
            var normal:Vector3D = out.normal;
            normal.x = toX - nearX;
            normal.y = toY - nearY;
            normal.z = box.z - (z + nearX * riseX + nearY * riseY);
            if (!(normal.z > 0))
            {
                return false;
            }
            normal.normalize();
            out.offset = maxAlong(normal);
            return true;
        }
    }
}
