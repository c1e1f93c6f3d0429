package flash.utils
{
    import standin.Machine;

    /** Calls a function with these arguments, once, when so many milliseconds are over; returns what clearTimeout takes. */
    public function setTimeout(closure:Function, delay:Number, ...args):uint
    {
        return Machine.setTimeout(function():void
            {
                closure.apply(null, args);
            }, delay);
    }
}
