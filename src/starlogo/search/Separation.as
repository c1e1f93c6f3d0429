package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Makes the depth of a contact separate: how far the first of two rows has to be moved along the normal until nothing of it touches the
     * second any more, however many parts of the two overlap.
     *
     * <p>Along a direction, places farther and farther out are tried until the two are apart; the sweep back from there touches where they part.
     * Where that is, the surfaces have a normal, and along it the way out is shorter than before, of convex bodies always (as the plane through the
     * point is crossed at the cosine of the angle). So the direction is improved until that ends. It begins with the normal of the contact that is
     * given, and with that axis of the world along which the extents overlap least, so that the depth is never more than that.</p>
     *
     * @private
     */
    public final class Separation
    {
        // Contacts less deep than this share of the larger extent keep their normal; the way out is looked for in steps from it on.
        private static const SHALLOW:Number = 1 / 256;

        // How often a normal is improved, and by how much a depth has to be less for it to count.
        private static const IMPROVEMENTS:int = 2;
        private static const GAIN:Number = 0.95;

        // Two normals whose sum is shorter have no direction between them.
        private static const NEARLY_OPPOSITE:Number = 0.1;

        // How narrow the interval is that the way out ends in before it is swept, as a share of the larger extent.
        private static const NARROW:Number = 1 / 16;

        // The extent of two points at the origin, so that all steps are longer than 0.
        private static const LEAST_EXTENT:Number = 1e-100;

        // Halvings, of which 53 leave nothing of a Number.
        private static const MOST_STEPS:int = 60;

        private var _pairs:RowPairs;
        private var _moved:MovedRow = new MovedRow();

        // The pair under way, where its first row is when they touch, and their larger extent.
        private var _table:AgentTable;
        private var _a:int;
        private var _b:int;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 0;
        private var _extent:Number = 0;
        private var _place:Vector3D = new Vector3D();

        // The direction that is tried; how far along it they touch, how far they do not, and where in between they part.
        private var _alongX:Number = 0;
        private var _alongY:Number = 0;
        private var _alongZ:Number = 0;
        private var _touching:Number = 0;
        private var _free:Number = 0;
        private var _exit:Number = 0;

        // Whether leaves decide in place of triangles.
        private var _byLeaves:Boolean = false;

        // How far along it the first is put: a field, because V8 makes objects of Numbers that are passed.
        private var _distance:Number = 0;

        // The sweep back, and the contact in which it ends.
        private var _back:RelativeMotion = new RelativeMotion();
        private var _left:ContactPoint = new ContactPoint();

        // The contact that was given; how the two part along the best normal so far.
        private var _start:ContactPoint = new ContactPoint();
        private var _parting:ContactPoint = new ContactPoint();

        /**
         * @param pairs decide which rows touch, and when
         */
        public function Separation(pairs:RowPairs)
        {
            _pairs = pairs;
        }

        /**
         * Makes a contact's normal and depth separate.
         *
         * @param motion of the first row, which ends where it is in the table, relative to the second, with the time when they touch
         * @param out the contact of two parts that touch then
         */
        public function find(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (_pairs.hasExactContact(table, a, b))
            {
                OverlapMiddle.setAlong(table, a, b, out);
                return;
            }
            begin(table, a, b, motion);
            _distance = 0;
            // only those that come may have been stopped just before they touch
            if (!isComing(motion) || touch())
            {
                findLeast(motion, out);
            }
            else
            {
                findTouch(motion, out);
            }
            _distance = 0;
            displace();
            OverlapMiddle.setAlong(table, a, b, out);
            OverlapMiddle.keepWithin(table.extents, a, out);
            if (table.forms[b] != ModelShape.GROUND)
            {
                OverlapMiddle.keepWithin(table.extents, b, out);
            }
            _moved.giveBack();
            _table = null;
        }

        private function begin(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            _table = table;
            _a = a;
            _b = b;
            _byLeaves = false;
            _moved.take(table, a);
            _x = table.x[a] + (motion.startX + time * motion.x);
            _y = table.y[a] + (motion.startY + time * motion.y);
            _z = table.z[a] + (motion.startZ + time * motion.z);
            var half:Number = Math.max(table.extents.largestHalf(b), _moved.largestHalf);
            // two points have none: then it is how far apart they may be and still touch
            var rounding:Number = table.marginOf(a) + table.marginOf(b);
            _extent = Math.max(2 * half, Math.max(rounding, LEAST_EXTENT));
        }

        // Rounding has them just not touching: there is no depth, and the motion's direction is the normal unless the two touch along theirs.
        private function findTouch(motion:RelativeMotion, out:ContactPoint):void
        {
            out.depth = 0;
            point(out);
            _distance = -Tolerances.SEPARATION / 4 * _extent;
            if (isComing(motion) && !touch())
            {
                out.pointAgainst(motion);
            }
        }

        // Whether there was no touch before the time.
        private static function isComing(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && (motion.x != 0 || motion.y != 0 || motion.z != 0);
        }

        // Leaves find a direction first, where triangles decide: they are quick.
        private function findLeast(motion:RelativeMotion, out:ContactPoint):void
        {
            var isDeep:Boolean = isDeepAlong(out);
            if (isDeep && isComing(motion))
            {
                _left.pointAgainst(motion);
                isDeep = isDeepAlong(_left);
            }
            if (isDeep && out.depth < SHALLOW * _extent && findCorner(out))
            {
                isDeep = isDeepAlong(_left);
            }
            if (isDeep)
            {
                findDirectionByLeaves(out);
                if (_pairs.trees != null && _pairs.trees.exact)
                {
                    point(out);
                    _free = out.depth;
                    goOut();
                    sweepBack(out);
                    improve(out);
                }
            }
            else
            {
                sweepBack(out);
            }
            if (isDeep)
            {
                // the middle between where they part and where the same of the first row is
                out.x = _left.x - out.depth / 2 * out.normalX;
                out.y = _left.y - out.depth / 2 * out.normalY;
                out.z = _left.z - out.depth / 2 * out.normalZ;
            }
            point(out);
            _exit = out.depth;
            makeSure();
            out.depth = _exit;
        }

        // Where the two touch two sides of a corner that are hardly deep, the way out is between both: takes the normal between a contact's and that of what
        // still touches a short way along the direction. Returns whether there is one.
        private function findCorner(contact:ContactPoint):Boolean
        {
            RelativeMotion.NONE.time = 0;
            _pairs.findContact(_table, _a, _b, RelativeMotion.NONE, _left);
            _left.setNormal(_left.normalX + contact.normalX, _left.normalY + contact.normalY, _left.normalZ + contact.normalZ);
            _left.normalise();
            return _left.length > NEARLY_OPPOSITE;
        }

        // Whether the two still touch a short way along a contact's normal.
        private function isDeepAlong(contact:ContactPoint):Boolean
        {
            point(contact);
            _touching = 0;
            _free = SHALLOW * _extent;
            return touchesFree();
        }

        private function findDirectionByLeaves(out:ContactPoint):void
        {
            _byLeaves = RowPairs.isOneTree(_table, _a, _b);
            findDirection(out);
            _byLeaves = false;
        }

        private function findDirection(out:ContactPoint):void
        {
            _start.copyFrom(out);
            _distance = 0;
            displace();
            _pairs.findOuterContact(_table, _a, _b, _left);
            point(_left);
            _free = _left.depth;
            goOut();
            sweepBack(out);
            _parting.copyFrom(_left);
            point(_start);
            _free = GAIN * out.depth;
            if (!tryUpToFree(out))
            {
                _left.copyFrom(_parting);
            }
            var left:int = IMPROVEMENTS;
            while (left > 0 && improve(out))
            {
                left--;
            }
        }

        // Takes the normal of the surfaces where the two part along the contact's, if that is a shorter way out. Returns whether it is.
        private function improve(out:ContactPoint):Boolean
        {
            var cosine:Number = _left.normalX * out.normalX + _left.normalY * out.normalY + _left.normalZ * out.normalZ;
            if (!(cosine > 0 && cosine < GAIN))
            {
                return false;
            }
            point(_left);
            _free = cosine * out.depth + Tolerances.SEPARATION * _extent;
            return tryUpToFree(out);
        }

        // Takes the direction if the two do not touch at the free distance along it. Returns whether it is.
        private function tryUpToFree(out:ContactPoint):Boolean
        {
            if (touchesFree())
            {
                return false;
            }
            _touching = 0;
            sweepBack(out);
            return true;
        }

        // Goes out along the direction, beyond the free distance, which is a guess, until the two do not touch.
        private function goOut():void
        {
            var step:Number = SHALLOW * _extent;
            _touching = 0;
            _free += Tolerances.SEPARATION * _extent;
            while (touchesFree() && _free < 1e300)
            {
                _touching = _free;
                _free += step;
                step *= 2;
            }
        }

        // Finds where the two part between where they touch and where they do not, and takes that for the contact's depth.
        private function sweepBack(out:ContactPoint):void
        {
            while (_free - _touching > NARROW * _extent)
            {
                halve();
            }
            _distance = _touching;
            displace();
            var way:Number = _touching - _free;
            _back.endAfter(way * _alongX, way * _alongY, way * _alongZ);
            if (_byLeaves)
            {
                _pairs.trees.findImpact(_table, _a, _b, _back, _left, true);
            }
            else
            {
                _pairs.findImpact(_table, _a, _b, _back, _left);
            }
            var time:Number = Math.min(_back.time, 1);
            out.normalX = _alongX;
            out.normalY = _alongY;
            out.normalZ = _alongZ;
            out.depth = _free + time * way;
        }

        private function halve():void
        {
            var middle:Number = (_touching + _free) / 2;
            _distance = middle;
            if (touch())
            {
                _touching = middle;
            }
            else
            {
                _free = middle;
            }
        }

        // Makes sure that the two are apart a little beyond the exit, and touch a little before it, in spite of rounding.
        private function makeSure():void
        {
            var slack:Number = Tolerances.SEPARATION / 4 * _extent;
            _touching = 0;
            _free = _exit + slack;
            if (touchesFree())
            {
                var step:Number = slack;
                do
                {
                    _touching = _free;
                    _free += step;
                    step *= 2;
                }
                while (touchesFree() && _free < 1e300);
            }
            else
            {
                _distance = _exit - slack;
                if (_exit <= slack || touch())
                {
                    return;
                }
                _free = _exit - slack;
            }
            for (var i:int = 0; i < MOST_STEPS && _free - _touching > slack; i++)
            {
                halve();
            }
            _exit = (_free + _touching) / 2;
        }

        private function point(contact:ContactPoint):void
        {
            _alongX = contact.normalX;
            _alongY = contact.normalY;
            _alongZ = contact.normalZ;
        }

        private function touchesFree():Boolean
        {
            _distance = _free;
            return touch();
        }

        // Whether the two touch when the first has been moved along the direction by the distance.
        private function touch():Boolean
        {
            displace();
            return _byLeaves ? _pairs.trees.areTouching(_table, _a, _b, true) : _pairs.areTouching(_table, _a, _b);
        }

        private function displace():void
        {
            _place.setTo(_x + _distance * _alongX, _y + _distance * _alongY, _z + _distance * _alongZ);
            _moved.put(_place, 0);
        }
    }
}
