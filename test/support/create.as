package support
{
    /** Calls a constructor, for <code>assertThrows</code>. */
    public function create(type:Class, ...args):*
    {
        var a:Array = args;
        switch (a.length)
        {
            case 1:
                return new type(a[0]);
            case 2:
                return new type(a[0], a[1]);
            case 3:
                return new type(a[0], a[1], a[2]);
            case 4:
                return new type(a[0], a[1], a[2], a[3]);
            case 5:
                return new type(a[0], a[1], a[2], a[3], a[4]);
            case 6:
                return new type(a[0], a[1], a[2], a[3], a[4], a[5]);
            case 7:
                return new type(a[0], a[1], a[2], a[3], a[4], a[5], a[6]);
            default:
                throw new ArgumentError("seven arguments at most, not " + a.length);
        }
    }
}
