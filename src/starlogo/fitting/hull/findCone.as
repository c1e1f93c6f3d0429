package starlogo.fitting.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * Looks for three faces around a direction: the direction is a sum of their normals with factors that are not negative. Faces in their order
     * around an edge are tried, a third of their number apart from each other.
     *
     * @param planes four numbers for each face: the outward unit normal, and the offset along it
     * @param faces the faces in their order around an edge
     * @param count the number of these faces, at least 3
     * @param upX the direction, of any length
     * @param upY of the direction
     * @param upZ of the direction
     * @return the position of the first of the three; the others follow after a third and two thirds of the count. -1 if none were found
     * @private
     */
    public function findCone(planes:Vector.<Number>, faces:Vector.<int>, count:int, upX:Number, upY:Number, upZ:Number):int
    {
        const MOST_TRIES:int = 2;
        for (var i:int = 0; i < MOST_TRIES; i++)
        {
            var a:int = 4 * faces[i];
            var b:int = 4 * faces[int((i + count / 3) % count)];
            var c:int = 4 * faces[int((i + 2 * count / 3) % count)];
            var aX:Number = planes[a];
            var aY:Number = planes[int(a + 1)];
            var aZ:Number = planes[int(a + 2)];
            var bX:Number = planes[b];
            var bY:Number = planes[int(b + 1)];
            var bZ:Number = planes[int(b + 2)];
            var cX:Number = planes[c];
            var cY:Number = planes[int(c + 1)];
            var cZ:Number = planes[int(c + 2)];
            var bcX:Number = bY * cZ - bZ * cY;
            var bcY:Number = bZ * cX - bX * cZ;
            var bcZ:Number = bX * cY - bY * cX;
            var determinant:Number = aX * bcX + aY * bcY + aZ * bcZ;
            if (determinant > Tolerances.HULL_FLAT && upX * bcX + upY * bcY + upZ * bcZ >= 0
                    && upX * (cY * aZ - cZ * aY) + upY * (cZ * aX - cX * aZ) + upZ * (cX * aY - cY * aX) >= 0
                    && upX * (aY * bZ - aZ * bY) + upY * (aZ * bX - aX * bZ) + upZ * (aX * bY - aY * bX) >= 0)
            {
                return i;
            }
        }
        return -1;
    }
}
