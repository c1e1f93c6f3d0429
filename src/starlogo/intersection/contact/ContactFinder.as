package starlogo.intersection.contact
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.BoxSegment;
    import starlogo.intersection.SegmentPair;

    /**
     * Where two structures touch, or how they overlap.
     *
     * <p>The normal points along the shortest way that frees the first from the second, and the depth is its length: moved by as much,
     * they touch. Where spheres and capsules have gone no deeper than to their centres and axes, that is the line between the points of
     * these, or of the box, that are nearest to each other. Deeper than that, and for boxes, it is the direction at right
     * angles to a face or to an edge of each along which they overlap least (Gottschalk, Lin and Manocha, "OBBTree", 1996). Where several
     * ways are equally short, one is chosen: centres that coincide are parted along z; a sphere or capsule on the axis of a capsule parallel to
     * it, or in line, leaves it at right angles and as upright as can be; in the middle of a box any of the faces will do.</p>
     *
     * <p>The point is in the middle of the overlap along the normal; of two boxes that touch in an edge or a face, and of a box with a
     * capsule's axis in it, in the middle of that too. Exact but for rounding; allocates nothing.</p>
     *
     * @private
     */
    public final class ContactFinder
    {
        private var _segments:SegmentPair = new SegmentPair();
        private var _segment:BoxSegment = new BoxSegment();
        private var _deep:DeepContact = new DeepContact();

        /** Nothing found yet. */
        public function ContactFinder()
        {
        }

        /**
         * Finds the contact of two structures.
         *
         * @param a a Sphere, Capsule or Box
         * @param b likewise, in the same space
         * @param x how far a is displaced from where it stands
         * @param y likewise
         * @param z likewise
         * @param out takes the result
         * @throws ArgumentError when there is no test for the pair
         */
        public function find(a:BoundingStructure, b:BoundingStructure, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            if (a.kind > b.kind)
            {
                // the other way round, and back
                find(b, a, -x, -y, -z, out);
                out.turn(x, y, z);
                return;
            }
            switch (a.kind << 2 | b.kind)
            {
                case 0:
                    sphereSphere(a as Sphere, b as Sphere, x, y, z, out);
                    return;
                case 1:
                    sphereCapsule(a as Sphere, b as Capsule, x, y, z, out);
                    return;
                case 2:
                    sphereBox(a as Sphere, b as Box, x, y, z, out);
                    return;
                case 5:
                    capsuleCapsule(a as Capsule, b as Capsule, x, y, z, out);
                    return;
                case 6:
                    capsuleBox(a as Capsule, b as Box, x, y, z, out);
                    return;
                case 10:
                    _deep.find(a, b, 0, x, y, z, out);
                    return;
                default:
                    throw new ArgumentError("there is no contact for " + a + " and " + b);
            }
        }

        private function sphereSphere(a:Sphere, b:Sphere, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var center:Vector3D = a.center;
            var middle:Vector3D = b.center;
            x += center.x;
            y += center.y;
            z += center.z;
            var gapX:Number = x - middle.x;
            var gapY:Number = y - middle.y;
            var gapZ:Number = z - middle.z;
            var squared:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            if (squared > 0)
            {
                out.pointAlong(gapX, gapY, gapZ);
            }
            else
            {
                out.pointAlong(0, 0, 1);
            }
            out.place(x, y, z, a.radius, a.radius + b.radius - Math.sqrt(squared));
        }

        private function sphereCapsule(sphere:Sphere, capsule:Capsule, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var start:Vector3D = capsule.start;
            var end:Vector3D = capsule.end;
            var center:Vector3D = sphere.center;
            var axisX:Number = end.x - start.x;
            var axisY:Number = end.y - start.y;
            var axisZ:Number = end.z - start.z;
            x += center.x;
            y += center.y;
            z += center.z;
            var gapX:Number = x - start.x;
            var gapY:Number = y - start.y;
            var gapZ:Number = z - start.z;
            var along:Number = gapX * axisX + gapY * axisY + gapZ * axisZ;
            var lengthSquared:Number = axisX * axisX + axisY * axisY + axisZ * axisZ;
            if (along > 0)
            {
                along = along < lengthSquared ? along / lengthSquared : 1;
                gapX -= along * axisX;
                gapY -= along * axisY;
                gapZ -= along * axisZ;
            }
            var radii:Number = sphere.radius + capsule.radius;
            var squared:Number = gapX * gapX + gapY * gapY + gapZ * gapZ;
            if (tellDirection(squared, Math.sqrt(lengthSquared) + radii))
            {
                out.pointAlong(gapX, gapY, gapZ);
            }
            else
            {
                out.pointAcross(axisX, axisY, axisZ);
                squared = 0;
            }
            out.place(x, y, z, sphere.radius, radii - Math.sqrt(squared));
        }

        private function sphereBox(sphere:Sphere, box:Box, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var center:Vector3D = sphere.center;
            var middle:Vector3D = box.center;
            var axisX:Vector3D = box.axisX;
            var axisY:Vector3D = box.axisY;
            var axisZ:Vector3D = box.axisZ;
            x += center.x;
            y += center.y;
            z += center.z;
            var gapX:Number = x - middle.x;
            var gapY:Number = y - middle.y;
            var gapZ:Number = z - middle.z;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            var px:Number = axisX.x * gapX + axisX.y * gapY + axisX.z * gapZ;
            var py:Number = axisY.x * gapX + axisY.y * gapY + axisY.z * gapZ;
            var pz:Number = axisZ.x * gapX + axisZ.y * gapY + axisZ.z * gapZ;
            var outX:Number = px > halfX ? px - halfX : (px < -halfX ? px + halfX : 0);
            var outY:Number = py > halfY ? py - halfY : (py < -halfY ? py + halfY : 0);
            var outZ:Number = pz > halfZ ? pz - halfZ : (pz < -halfZ ? pz + halfZ : 0);
            var squared:Number = outX * outX + outY * outY + outZ * outZ;
            if (tellDirection(squared, halfX + halfY + halfZ + sphere.radius))
            {
                out.pointAlong(outX * axisX.x + outY * axisY.x + outZ * axisZ.x, outX * axisX.y + outY * axisY.y + outZ * axisZ.y,
                        outX * axisX.z + outY * axisY.z + outZ * axisZ.z);
                out.place(x, y, z, sphere.radius, sphere.radius - Math.sqrt(squared));
                return;
            }
            // out through the nearest face
            var axis:Vector3D = axisX;
            var along:Number = px;
            var depth:Number = halfX - Math.abs(px);
            if (halfY - Math.abs(py) < depth)
            {
                axis = axisY;
                along = py;
                depth = halfY - Math.abs(py);
            }
            if (halfZ - Math.abs(pz) < depth)
            {
                axis = axisZ;
                along = pz;
                depth = halfZ - Math.abs(pz);
            }
            var side:Number = along < 0 ? -1 : 1;
            out.pointAlong(side * axis.x, side * axis.y, side * axis.z);
            out.place(x, y, z, sphere.radius, sphere.radius + depth);
        }

        private function capsuleCapsule(a:Capsule, b:Capsule, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var segments:SegmentPair = _segments;
            segments.relate(a, b);
            segments.findNearest(segments.x + x, segments.y + y, segments.z + z);
            var radii:Number = a.radius + b.radius;
            var squared:Number = segments.gapX * segments.gapX + segments.gapY * segments.gapY + segments.gapZ * segments.gapZ;
            if (tellDirection(squared, segments.lengths + radii))
            {
                out.pointAlong(segments.gapX, segments.gapY, segments.gapZ);
            }
            else
            {
                segments.pointAcross(x, y, z, out);
                squared = 0;
            }
            var start:Vector3D = a.start;
            var end:Vector3D = a.end;
            var s:Number = segments.s;
            out.place(x + start.x + s * (end.x - start.x), y + start.y + s * (end.y - start.y), z + start.z + s * (end.z - start.z), a.radius,
                    radii - Math.sqrt(squared));
        }

        private function capsuleBox(capsule:Capsule, box:Box, x:Number, y:Number, z:Number, out:ContactPoint):void
        {
            var segment:BoxSegment = _segment;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            segment.relate(capsule, box);
            segment.turn(x, y, z);
            var px:Number = segment.x + segment.wayX;
            var py:Number = segment.y + segment.wayY;
            var pz:Number = segment.z + segment.wayZ;
            var along:Number = segment.nearest(px, py, pz, halfX, halfY, halfZ);
            px += along * segment.alongX;
            py += along * segment.alongY;
            pz += along * segment.alongZ;
            px = px > halfX ? px - halfX : (px < -halfX ? px + halfX : 0);
            py = py > halfY ? py - halfY : (py < -halfY ? py + halfY : 0);
            pz = pz > halfZ ? pz - halfZ : (pz < -halfZ ? pz + halfZ : 0);
            var squared:Number = px * px + py * py + pz * pz;
            var size:Number = segment.alongX + segment.alongY + segment.alongZ + halfX + halfY + halfZ + capsule.radius;
            if (tellDirection(squared, size))
            {
                segment.turnBack(px, py, pz, out);
                var start:Vector3D = capsule.start;
                var end:Vector3D = capsule.end;
                out.place(x + start.x + along * (end.x - start.x), y + start.y + along * (end.y - start.y), z + start.z + along * (end.z - start.z),
                        capsule.radius, capsule.radius - Math.sqrt(squared));
            }
            else
            {
                _deep.find(capsule, box, capsule.radius, x, y, z, out);
            }
            segment.end();
        }

        // Whether the way between two nearest points is long enough to have a direction, in spite of rounding.
        private static function tellDirection(squared:Number, size:Number):Boolean
        {
            var least:Number = Tolerances.DIRECTION * size;
            return squared > least * least;
        }
    }
}
