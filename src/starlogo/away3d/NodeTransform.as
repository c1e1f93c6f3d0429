package starlogo.away3d
{
    import away3d.core.base.Object3D;
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    /**
     * Where a part of a tree of Away3D's is in the tree's own space, in Away3D's axes.
     *
     * <p>It is computed from the objects' traits: a Matrix3D has single precision in Flash Player. Where an object's matrix
     * says something else, that is what Away3D draws, and what counts: its DAEParser writes there alone.</p>
     */
    internal final class NodeTransform
    {
        private static var sPlacement:Placement = new Placement();
        private static var sMatrix:Vector.<Number> = new Vector.<Number>(16, true);

        // Four columns of three: where the axes and the origin come to.
        private var _columns:Vector.<Number> = new <Number>[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0];

        /** The transform of the tree's root: nothing is moved. */
        public function NodeTransform()
        {
        }

        /** Whether it turns the inside out. */
        public function get isMirrored():Boolean
        {
            var c:Vector.<Number> = _columns;
            return c[0] * (c[4] * c[8] - c[5] * c[7]) - c[3] * (c[1] * c[8] - c[2] * c[7]) + c[6] * (c[1] * c[5] - c[2] * c[4]) < 0;
        }

        /** The transform of a child of the object with this one. */
        public function ofChild(child:Object3D):NodeTransform
        {
            var local:NodeTransform = new NodeTransform();
            local.readTraits(child);
            child.transform.copyRawDataTo(sMatrix);
            if (!local.isAsIn(sMatrix))
            {
                local.readMatrix(sMatrix);
            }
            var placed:NodeTransform = new NodeTransform();
            for (var i:int = 0; i < 12; i += 3)
            {
                for (var row:int = 0; row < 3; row++)
                {
                    placed._columns[i + row] = _columns[row] * local._columns[i] + _columns[row + 3] * local._columns[i + 1]
                        + _columns[row + 6] * local._columns[i + 2] + (i == 9 ? _columns[row + 9] : 0);
                }
            }
            return placed;
        }

        /** The coordinate 0, 1 or 2 of where a point comes to. */
        public function coordinate(axis:int, x:Number, y:Number, z:Number):Number
        {
            return _columns[axis] * x + _columns[axis + 3] * y + _columns[axis + 6] * z + _columns[axis + 9];
        }

        // Scaled, turned about the pivot point, moved: T(position) T(pivot) R T(-pivot) S.
        private function readTraits(object:Object3D):void
        {
            var p:Placement = sPlacement;
            p.setRotation(object.rotationZ, object.rotationY, object.rotationX);
            setColumn(0, p.r00, p.r10, p.r20, object.scaleX);
            setColumn(3, p.r01, p.r11, p.r21, object.scaleY);
            setColumn(6, p.r02, p.r12, p.r22, object.scaleZ);
            var pivot:Vector3D = object.pivotPoint;
            _columns[9] = object.x + pivot.x - (p.r00 * pivot.x + p.r01 * pivot.y + p.r02 * pivot.z);
            _columns[10] = object.y + pivot.y - (p.r10 * pivot.x + p.r11 * pivot.y + p.r12 * pivot.z);
            _columns[11] = object.z + pivot.z - (p.r20 * pivot.x + p.r21 * pivot.y + p.r22 * pivot.z);
        }

        private function setColumn(first:int, x:Number, y:Number, z:Number, scale:Number):void
        {
            _columns[first] = x * scale;
            _columns[first + 1] = y * scale;
            _columns[first + 2] = z * scale;
        }

        private function readMatrix(matrix:Vector.<Number>):void
        {
            for (var i:int = 0; i < 12; i++)
            {
                _columns[i] = matrix[i + int(i / 3)];
            }
        }

        // Up to what single precision leaves of it: of the scale in three columns, of the position in the fourth.
        private function isAsIn(matrix:Vector.<Number>):Boolean
        {
            var scale:Number = 0;
            var difference:Number = 0;
            for (var i:int = 0; i < 12; i++)
            {
                if (i == 9)
                {
                    if (!(difference <= scale * Tolerances.SINGLE_PRECISION))
                    {
                        return false;
                    }
                    difference = 0;
                }
                scale = Math.max(scale, Math.abs(_columns[i]));
                difference = Math.max(difference, Math.abs(_columns[i] - matrix[i + int(i / 3)]));
            }
            return difference <= scale * Tolerances.SINGLE_PRECISION;
        }
    }
}
