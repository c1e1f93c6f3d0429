package starlogo.intersection
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Placement;

    /**
     * Every feature of a structure (face, edge, corner, side, cap) against every feature of another, in a miss, an
     * exact contact, a touch and a deep hit, turned against each other in several ways, the whole of it under several
     * transforms.
     */
    public class ContactsTest
    {
        private static const MISS:Number = 1e-6;
        private static const CONTACT:Number = 0;
        private static const TOUCH:Number = -1e-6;
        private static const DEEP:Number = -0.1;
        // the first transforms: they keep an exact contact but for rounding, positions being no larger than structures
        private static const PRECISE_TRANSFORMS:int = 2;
        private static const SPINS:Array = [0, Math.PI / 2, 1e-9, 1e-4, 0.7];

        private static var sPlacements:Vector.<Placement>;

        [BeforeClass]
        public static function makePlacements():void
        {
            sPlacements = Vector.<Placement>([
                        placement(1, 0, 0, 0, 0, 0, 0),
                        placement(1, 30, -50, 110, 2, -3, 0.5),
                        placement(1e-4, -75, 15, 200, 0.01, 0.02, -0.03),
                        placement(1e4, 20, 80, -40, 7, -3, 12),
                        placement(1, 145, 10, 65, 1e4, -1e4, 1e4)]);
        }

        [Test]
        public function sphereSphere():void
        {
            // without a tolerance, as nothing is computed on the way: contact is left to rounding
            check(sphere(), spheresFeatures(), sphere(), spheresFeatures(), [MISS, TOUCH, DEEP]);
        }

        [Test]
        public function sphereCapsule():void
        {
            check(sphere(), spheresFeatures(), capsule(), capsulesFeatures());
        }

        [Test]
        public function sphereBox():void
        {
            check(sphere(), spheresFeatures(), box(), boxsFeatures());
        }

        [Test]
        public function capsuleCapsule():void
        {
            check(capsule(), capsulesFeatures(), capsule(), capsulesFeatures());
        }

        [Test]
        public function capsuleBox():void
        {
            check(capsule(), capsulesFeatures(), box(), boxsFeatures());
        }

        [Test]
        public function boxBox():void
        {
            check(box(), boxsFeatures(), box(), boxsFeatures());
        }

        private static function check(a:BoundingStructure, featuresA:Array, b:BoundingStructure, featuresB:Array,
                gaps:Array = null):void
        {
            for each (var featureA:Array in featuresA)
            {
                for each (var featureB:Array in featuresB)
                {
                    for each (var spin:Number in SPINS)
                    {
                        for each (var gap:Number in gaps || [MISS, CONTACT, TOUCH, DEEP])
                        {
                            var there:BoundingStructure = b.place(facing(featureA, featureB, spin, gap));
                            var name:String = featureA[0] + " to " + featureB[0] + ", spin " + spin + ", gap " + gap;
                            var transforms:int = gap == CONTACT ? PRECISE_TRANSFORMS : sPlacements.length;
                            checkUnderTransforms(name, gap <= 0, a, there, transforms);
                        }
                    }
                }
            }
        }

        private static function checkUnderTransforms(name:String, isHit:Boolean, a:BoundingStructure, b:BoundingStructure,
                transforms:int):void
        {
            for (var i:int = 0; i < transforms; i++)
            {
                var placedA:BoundingStructure = a.place(sPlacements[i]);
                var placedB:BoundingStructure = b.place(sPlacements[i]);
                assertEquals(name + ", transform " + i, isHit, intersects(placedA, placedB));
                assertEquals(name + ", transform " + i + ", swapped", isHit, intersects(placedB, placedA));
            }
        }

        /** Turns and moves b so that its feature faces a's, at a gap: its outward direction against a's. */
        private static function facing(featureA:Array, featureB:Array, spin:Number, gap:Number):Placement
        {
            var out:Vector3D = featureA[2].clone();
            var to:Vector.<Vector3D> = frame(new Vector3D(-out.x, -out.y, -out.z), spin);
            var from:Vector.<Vector3D> = frame(featureB[2], 0);
            var result:Placement = new Placement();
            result.isIdentity = false;
            result.r00 = to[0].x * from[0].x + to[1].x * from[1].x + to[2].x * from[2].x;
            result.r01 = to[0].x * from[0].y + to[1].x * from[1].y + to[2].x * from[2].y;
            result.r02 = to[0].x * from[0].z + to[1].x * from[1].z + to[2].x * from[2].z;
            result.r10 = to[0].y * from[0].x + to[1].y * from[1].x + to[2].y * from[2].x;
            result.r11 = to[0].y * from[0].y + to[1].y * from[1].y + to[2].y * from[2].y;
            result.r12 = to[0].y * from[0].z + to[1].y * from[1].z + to[2].y * from[2].z;
            result.r20 = to[0].z * from[0].x + to[1].z * from[1].x + to[2].z * from[2].x;
            result.r21 = to[0].z * from[0].y + to[1].z * from[1].y + to[2].z * from[2].y;
            result.r22 = to[0].z * from[0].z + to[1].z * from[1].z + to[2].z * from[2].z;
            var p:Vector3D = featureB[1];
            result.x = featureA[1].x + gap * out.x - (result.r00 * p.x + result.r01 * p.y + result.r02 * p.z);
            result.y = featureA[1].y + gap * out.y - (result.r10 * p.x + result.r11 * p.y + result.r12 * p.z);
            result.z = featureA[1].z + gap * out.z - (result.r20 * p.x + result.r21 * p.y + result.r22 * p.z);
            return result;
        }

        /** Three unit vectors at right angles, of which the first is given. */
        private static function frame(first:Vector3D, spin:Number):Vector.<Vector3D>
        {
            var helper:Vector3D = Math.abs(first.z) < 0.9 ? Vector3D.Z_AXIS : Vector3D.X_AXIS;
            var second:Vector3D = first.crossProduct(helper);
            second.normalize();
            var third:Vector3D = first.crossProduct(second);
            var cosine:Number = Math.cos(spin);
            var sine:Number = Math.sin(spin);
            var turned:Vector3D = new Vector3D(
                    cosine * second.x + sine * third.x, cosine * second.y + sine * third.y, cosine * second.z + sine * third.z);
            return Vector.<Vector3D>([first, turned, first.crossProduct(turned)]);
        }

        private static function sphere():Sphere
        {
            return new Sphere(new Vector3D(0.2, -0.1, 0.3), 0.4);
        }

        private static function spheresFeatures():Array
        {
            return [feature("pole", sphere().center, new Vector3D(0, 0, 1), 0.4),
                    feature("side", sphere().center, new Vector3D(1, -2, 2), 0.4)];
        }

        private static function capsule():Capsule
        {
            return new Capsule(new Vector3D(0.5, 0.2, 0), new Vector3D(-0.3, 0.2, 0.6), 0.25);
        }

        private static function capsulesFeatures():Array
        {
            var start:Vector3D = capsule().start;
            var end:Vector3D = capsule().end;
            var middle:Vector3D = new Vector3D(0.1, 0.2, 0.3);
            return [feature("tip", start, new Vector3D(4, 0, -3), 0.25),
                    feature("cap", end, new Vector3D(-3, 3, 4), 0.25),
                    feature("side", middle, new Vector3D(3, 0, 4), 0.25),
                    feature("flank", middle, new Vector3D(0, -1, 0), 0.25)];
        }

        private static function box():Box
        {
            return new Box(new Vector3D(-0.2, 0.1, 0.4), new Vector3D(0.6, 0.8, 0), new Vector3D(-0.8, 0.6, 0),
                    new Vector3D(0, 0, 1), 0.5, 0.3, 0.7);
        }

        private static function boxsFeatures():Array
        {
            var features:Array = [];
            var directions:Array = [
                    [1, 0, 0], [0, -1, 0], [0, 0, 1], [1, 1, 0], [0, -1, 1], [-1, 0, -1], [1, 1, 1], [-1, 1, -1]];
            for each (var signs:Array in directions)
            {
                var local:Vector3D = new Vector3D(signs[0], signs[1], signs[2]);
                var names:Array = ["", "face", "edge", "corner"];
                var name:String = names[int(local.lengthSquared)] + " " + signs;
                var point:Vector3D = turned(box(), new Vector3D(0.5 * local.x, 0.3 * local.y, 0.7 * local.z));
                features.push(feature(name, point.add(box().center), turned(box(), local), 0));
            }
            return features;
        }

        private static function turned(of:Box, local:Vector3D):Vector3D
        {
            return new Vector3D(
                    local.x * of.axisX.x + local.y * of.axisY.x + local.z * of.axisZ.x,
                    local.x * of.axisX.y + local.y * of.axisY.y + local.z * of.axisZ.y,
                    local.x * of.axisX.z + local.y * of.axisY.z + local.z * of.axisZ.z);
        }

        /** A name, a point of the surface, and a direction in which no other point of the structure is farther out. */
        private static function feature(name:String, center:Vector3D, direction:Vector3D, radius:Number):Array
        {
            var length:Number = Math.sqrt(direction.lengthSquared);
            var out:Vector3D = new Vector3D(direction.x / length, direction.y / length, direction.z / length);
            var point:Vector3D = new Vector3D(center.x + radius * out.x, center.y + radius * out.y, center.z + radius * out.z);
            return [name, point, out];
        }

        private static function placement(size:Number, heading:Number, pitch:Number, roll:Number,
                x:Number, y:Number, z:Number):Placement
        {
            var result:Placement = new Placement();
            result.size = size;
            result.setRotation(heading, pitch, roll);
            result.x = x;
            result.y = y;
            result.z = z;
            return result;
        }
    }
}
